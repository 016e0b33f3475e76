#include "reference/own_surface.h"

#include <algorithm>

#include "reference/texture.h"

namespace opaline::reference {

namespace {

double normalScaleOf(const Body& body) {
  return double{body.opaque ? body.opaque->normalScale : body.surface->normalScale};
}

}  // namespace

const std::optional<Texture>& normalTextureOf(const Body& body) {
  static const std::optional<Texture> none;
  if (body.opaque) return body.opaque->normalTexture;
  return body.surface ? body.surface->normalTexture : none;
}

Vector normalAt(const Body& body, const SurfacePoint& point, const Vector& ofMesh) {
  const std::optional<Texture>& texture = normalTextureOf(body);
  if (!texture || body.tangents.empty()) return ofMesh;
  const auto told = [&](std::size_t channel) {
    return 2 * textureAt(body, point, texture, channel, TexelKind::Number) - 1;
  };
  const double scale = normalScaleOf(body);
  const scene::TriangleTangents& tangents = body.tangents[point.triangle];
  const Triangle& corners = body.triangles[point.triangle];
  const Vector& first = body.positionsMm[corners[0]];
  const Vector toSecond = body.positionsMm[corners[1]] - first;
  const Vector toThird = body.positionsMm[corners[2]] - first;
  Vector tangent{};
  for (std::size_t k = 0; k < 3; ++k)
    tangent += point.weights[k] * unitOr(double{tangents.corners[k][0]} * toSecond +
                                             double{tangents.corners[k][1]} * toThird,
                                         {});
  const Vector along = unitOr(tangent - dot(tangent, ofMesh) * ofMesh, {});
  const Vector across = double{tangents.side} * cross(ofMesh, along);
  return unitOr(scale * told(0) * along + scale * told(1) * across + told(2) * ofMesh, ofMesh);
}

double alphaAt(const Body& body, const SurfacePoint& point, double standard) {
  constexpr std::size_t green = 1;
  double roughness = standard;
  if (body.surface && (body.surface->roughness || body.surface->metallicRoughnessTexture)) {
    const auto& texture = body.surface->metallicRoughnessTexture;
    roughness = double{body.surface->roughness.value_or(1)} *
                textureAt(body, point, texture, green, TexelKind::Number);
    roughness = std::clamp(roughness, 0.02, 1.0);
  }
  return roughness * roughness;
}

}  // namespace opaline::reference
