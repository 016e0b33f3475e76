#include "reference/path/through_media.h"

#include <algorithm>
#include <cmath>

namespace opaline::reference {

ThroughMedia::ThroughMedia(const Geometry& geometry, const InteriorsByChannel& interiors)
    : geometry_(geometry), interiors_(interiors) {
  for (std::size_t c = 0; c < 3; ++c) densest_[c] = densestOf(geometry.scene(), interiors[c]);
}

Colour ThroughMedia::pastLayer(const SurfacePoint& point, double cosine) const {
  Colour share{1, 1, 1};
  for (std::size_t c = 0; c < 3; ++c) share[c] = interiors_[c][point.body].passing(point, cosine);
  return share;
}

// By Beer's law or, in a body of several media, by ratio tracking (Novák et al. 2014).
Colour ThroughMedia::left(std::uint32_t body, const Vector& place, const Vector& direction,
                          double distanceMm, Random& random) const {
  Colour share{1, 1, 1};
  for (std::size_t c = 0; c < 3; ++c) {
    const double densest = densest_[c][body];
    if (densest <= 0) {
      share[c] = std::exp(-interiors_[c][body].sigmaTPerMm * distanceMm);
      continue;
    }
    for (double at = -std::log(random()) / densest; at < distanceMm && share[c] > 0;
         at -= std::log(random()) / densest) {
      const std::uint32_t part = geometry_.nearestPart(body, place + at * direction);
      share[c] *= 1 - interiors_[c][part].sigmaTPerMm / densest;
    }
  }
  return share;
}

std::optional<ThroughMedia::Exit> ThroughMedia::from(const SurfacePoint& point,
                                                     const Vector& direction,
                                                     Random& random) const {
  constexpr double leastShare = 1e-5;
  constexpr int mostSurfaces = 1000;
  const Scene& scene = geometry_.scene();
  std::uint32_t body = point.body;
  const std::uint32_t whole = wholeOf(scene, body);
  const Vector& facet = point.facetNormal;
  const Vector normal = normalAt(scene.bodies[body], point, facet);
  if (dot(direction, facet) >= 0 || dot(direction, normal) >= 0) return std::nullopt;
  Exit way{point, refractedInto(facet, direction, normal, interiors_[0][body].eta)};
  way.share = pastLayer(point, -dot(way.direction, facet));
  int depth = 1;  // how many nested parts of the body it is in
  for (int surface = 0; surface < mostSurfaces; ++surface) {
    const auto hit = geometry_.closestHit(way.point, way.direction);
    if (!hit) return std::nullopt;
    way.share =
        product(way.share, left(body, way.point.position, way.direction, hit->distanceMm, random));
    if (*std::ranges::max_element(way.share) < leastShare) return std::nullopt;
    way.point = hit->point;
    way.isOpaque = scene.bodies[hit->point.body].opaque.has_value();
    if (way.isOpaque) return way;
    if (wholeOf(scene, hit->point.body) != whole) continue;
    const double cosine = std::min(dot(way.direction, hit->point.facetNormal), 1.0);
    if (cosine <= 0) ++depth;
    if (cosine <= 0 || --depth > 0) continue;
    depth = 1;
    body = hit->point.body;
    const double eta = interiors_[0][body].eta;
    way.share = product(way.share, pastLayer(hit->point, cosine));
    if (random() >= bssrdf::fresnelReflectanceInside(eta, cosine)) {
      way.direction = refracted(way.direction, -hit->point.facetNormal, 1 / eta);
      return way;
    }
    way.direction = mirrored(way.direction, hit->point.facetNormal);
    way.share = product(way.share, pastLayer(hit->point, cosine));
  }
  return std::nullopt;
}

}  // namespace opaline::reference
