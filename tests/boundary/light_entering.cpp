#include "boundary/light_entering.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "boundary/channel.h"

namespace opaline::test::boundary {

using namespace reference;

namespace {

double areaOf(const Body& body, std::uint32_t triangle) {
  const Triangle& corners = body.triangles[triangle];
  const Vector& a = body.positionsMm[corners[0]];
  return length(cross(body.positionsMm[corners[1]] - a, body.positionsMm[corners[2]] - a)) / 2;
}

/// Follows light of some flux, mirrored at a point, to where it enters next.
void followOutside(const Geometry& geometry, const TriangleClusters& clusters, double eta,
                   SurfacePoint from, Vector direction, double flux,
                   std::vector<double>& mirrored) {
  constexpr int most = 4;
  for (int k = 0; k < most; ++k) {
    const Vector& normal = from.facetNormal;
    direction = unitOr(direction - 2 * dot(direction, normal) * normal, direction);
    const auto hit = geometry.closestHit(from, direction);
    if (!hit) return;
    const double cosine = std::min(1.0, std::abs(dot(direction, hit->point.facetNormal)));
    const double reflectance = reflectanceOutside(eta, cosine);
    const std::uint32_t at = clusters.ofTriangle[hit->point.triangle];
    mirrored[at] += flux * (1 - reflectance) / clusters.list[at].areaMm2;
    flux *= reflectance;
    from = hit->point;
  }
}

}  // namespace

LightEntering lightEntering(const Geometry& geometry, const TriangleClusters& clusters, double eta,
                            const Vector& directionToLight) {
  constexpr std::array<double, 3> middle{1.0 / 3, 1.0 / 3, 1.0 / 3};
  const std::size_t count = clusters.count();
  const Body& body = geometry.scene().bodies.front();
  LightEntering light{std::vector<double>(count, 0), clusters, std::vector<double>(count, 0)};
  std::vector<double> flux(count, 0);
  std::vector<Vector> centroid(count, Vector{});
  std::vector<Vector> normal(count, Vector{});
  std::vector<std::uint32_t> lit;
  for (std::uint32_t t = 0; t < body.triangles.size(); ++t) {
    const SurfacePoint point = geometry.pointOn(0, t, middle);
    const double cosine = std::min(1.0, dot(point.facetNormal, directionToLight));
    if (cosine <= 0 || geometry.occluded(point, directionToLight)) continue;
    lit.push_back(t);
    const double arriving = cosine * areaOf(body, t);
    const double reflectance = reflectanceOutside(eta, cosine);
    const double entering = arriving * (1 - reflectance);
    const std::uint32_t cluster = clusters.ofTriangle[t];
    flux[cluster] += entering;
    centroid[cluster] += entering * point.position;
    normal[cluster] += entering * point.facetNormal;
    followOutside(geometry, clusters, eta, point, -directionToLight, arriving * reflectance,
                  light.mirrored);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (flux[i] <= 0) continue;
    light.irradiance[i] = flux[i] / clusters.list[i].areaMm2;
    light.places.list[i].centroidMm = (1 / flux[i]) * centroid[i];
    light.places.list[i].normal = unitOr(normal[i], clusters.list[i].normal);
  }
  std::vector<double> nearest(count, std::numeric_limits<double>::infinity());
  for (const std::uint32_t t : lit) {
    const std::uint32_t cluster = clusters.ofTriangle[t];
    const SurfacePoint point = geometry.pointOn(0, t, middle);
    const double distance = length(point.position - light.places.list[cluster].centroidMm);
    if (distance >= nearest[cluster]) continue;
    nearest[cluster] = distance;
    light.places.list[cluster].start = point;
  }
  return light;
}

}  // namespace opaline::test::boundary
