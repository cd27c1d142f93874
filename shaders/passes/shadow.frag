#version 450 core
// Only the depth of a solid surface is kept in a light's map.
void main() {}
