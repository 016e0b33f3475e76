#include "reference/opaque_surface.h"

#include <algorithm>
#include <cmath>

#include "reference/texture.h"

namespace opaline::reference {

namespace {

constexpr std::size_t green = 1;
constexpr std::size_t blue = 2;
constexpr std::size_t alpha = 3;

Colour colorAt(const Body& body, const SurfacePoint& point, const Rgb& factor,
               const std::optional<Texture>& texture) {
  Colour color{};
  for (std::size_t c = 0; c < 3; ++c)
    color[c] = double{factor[c]} * textureAt(body, point, texture, c, TexelKind::Color);
  return color;
}

}  // namespace

OpaqueSurface opaqueSurfaceAt(const Body& body, const SurfacePoint& point) {
  const OpaqueMaterial& material = *body.opaque;
  const auto number = [&](const std::optional<Texture>& texture, std::size_t channel) {
    return textureAt(body, point, texture, channel, TexelKind::Number);
  };
  Colour base = colorAt(body, point, material.baseColor, material.baseColorTexture);
  for (std::size_t c = 0; c < 3; ++c)
    base[c] = std::clamp(base[c] * vertexColorAt(body, point, c), 0.0, 1.0);
  OpaqueSurface surface;
  if (material.unlit) {
    surface.unlit = true;
    surface.emission = base;
    return surface;
  }
  const auto& shine = material.metallicRoughnessTexture;
  const double metallic = std::clamp(double{material.metallic} * number(shine, blue), 0.0, 1.0);
  const double roughness = std::clamp(double{material.roughness} * number(shine, green), 0.02, 1.0);
  const double strength = double{material.specular} * number(material.specularTexture, alpha);
  const Colour tint = colorAt(body, point, material.specularColor, material.specularColorTexture);
  const double through = std::clamp(
      double{material.diffuseTransmission} * number(material.diffuseTransmissionTexture, alpha),
      0.0, 1.0);
  const Colour behind = colorAt(body, point, material.diffuseTransmissionColor,
                                material.diffuseTransmissionColorTexture);
  const double ior{material.ior};
  const double headOn = std::pow((ior - 1) / (ior + 1), 2);
  for (std::size_t c = 0; c < 3; ++c) {
    surface.diffuse[c] = (1 - metallic) * (1 - through) * base[c];
    surface.through[c] = (1 - metallic) * through * std::min(behind[c], 1.0);
    surface.dielectric[c] = std::min(headOn * tint[c], 1.0) * strength;
  }
  surface.grazing = strength;
  surface.metal = base;
  surface.metallic = metallic;
  surface.alpha = roughness * roughness;
  surface.occlusion =
      std::lerp(1.0, number(material.occlusionTexture, 0), double{material.occlusionStrength});
  surface.emission = colorAt(body, point, material.emission, material.emissionTexture);
  return surface;
}

namespace {

// Mean over the hemisphere of the reflectance by Schlick 1994.
double meanShare(double headOn, double grazing) {
  return std::lerp(headOn, grazing, 1.0 / 21);
}

double leftByDielectric(const OpaqueSurface& surface) {
  return 1 -
         meanShare(std::max({surface.dielectric[0], surface.dielectric[1], surface.dielectric[2]}),
                   surface.grazing);
}

}  // namespace

double mattShare(const OpaqueSurface& surface, std::size_t channel) {
  const double mirrored = std::lerp(meanShare(surface.dielectric[channel], surface.grazing),
                                    meanShare(surface.metal[channel], 1), surface.metallic);
  return mirrored + leftByDielectric(surface) * surface.diffuse[channel];
}

double shareInMedium(const OpaqueSurface& surface, std::size_t channel) {
  return surface.diffuse[channel] + surface.metallic * surface.metal[channel];
}

bool isCutOut(const Body& body, std::uint32_t triangle, const std::array<double, 3>& weights) {
  const OpaqueMaterial& material = *body.opaque;
  SurfacePoint point;
  point.triangle = triangle;
  point.weights = weights;
  const double found = double{material.alpha} * vertexColorAt(body, point, alpha) *
                       textureAt(body, point, material.baseColorTexture, alpha, TexelKind::Number);
  return found < double{material.alphaCutoff};
}

}  // namespace opaline::reference
