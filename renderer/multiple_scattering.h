// What a single bounce off a rough surface loses, and how it is given back.
#pragma once

namespace glint {

// Kulla and Conty 2017, "Revisiting Physically Based Shading at Imageworks": the lobe of all further bounces for white
// facets, without cosine, from the directional albedos towards light and view and their average.
constexpr double kullaContyLobe(double albedoLight, double albedoView, double averageAlbedo) {
  constexpr double kPi = 3.14159265358979323846;
  return (1 - albedoLight) * (1 - albedoView) / (kPi * (1 - averageAlbedo));
}

// What facets of reflectance F (the same at every angle) keep of that lobe: a geometric series of bounces.
constexpr double kullaContyTint(double F, double averageAlbedo) {
  return F * F * averageAlbedo / (1 - F * (1 - averageAlbedo));
}

// Turquin 2019, "Practical multiple scattering compensation for microfacet models", eq. 16: scales the single bounce.
constexpr double turquinScale(double F0, double albedoView) { return 1 + F0 * (1 - albedoView) / albedoView; }

}  // namespace glint
