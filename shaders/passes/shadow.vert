#version 450 core
// A solid surface in a light's map.
layout(location = 0) in vec3 inPosition;
uniform mat4 mapFromModel;     // clip space of the map

void main() { gl_Position = mapFromModel * vec4(inPosition, 1.0); }
