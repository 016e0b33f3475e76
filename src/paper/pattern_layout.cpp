#include "paper/pattern_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>

#include "bssrdf/profile.h"
#include "paper/atlas/geodesic.h"
#include "paper/atlas/texel_area.h"

namespace opaline::paper {

namespace {

// Area of the smallest object of a medium.
double smallestAreaMm2(const RestScene& scene, std::size_t medium) {
  double smallest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < scene.mediumOfObject.size(); ++i)
    if (scene.mediumOfObject[i] == medium) smallest = std::min(smallest, scene.areaOfObjectMm2[i]);
  return smallest;
}

// Finds where far samples lie among the cells and how much surface each stands for.
class FarPlacer {
 public:
  FarPlacer(const core::RestSurface& surface, const atlas::Atlas& atlas,
            const atlas::Neighbourhoods& cells, int mapSize)
      : surface_(surface), atlas_(atlas), cells_(cells), mapSize_(mapSize) {}

  // The ring that the samples stand for begins at `innerMm`; a walk that ends early finds part of
  // it.
  void add(const atlas::GeodesicStar& star, double innerMm, double distanceMm) {
    const std::size_t first = places_.size();
    std::array<glm::dvec3, 8> ends{};
    for (std::size_t i = 0; i < star.size(); ++i) {
      places_.push_back(placeOf(star[i]));
      ends[i] = positionOf(star[i]);
    }
    // Walks that start 45° apart end that far apart on a plane.
    const auto onPlane = [&](std::size_t a, std::size_t b) {
      return std::sin(std::numbers::pi / 8) *
             (static_cast<double>(star[a].walkedMm) + static_cast<double>(star[b].walkedMm));
    };
    for (std::size_t i = 0; i < star.size(); ++i) {
      if (star[i].triangle == atlas::SurfacePoint::nowhere) continue;
      double apart = 0;
      double expected = 0;
      for (const std::size_t other : {(i + 1) % 8, (i + 7) % 8})
        if (star[other].triangle != atlas::SurfacePoint::nowhere) {
          apart += glm::length(ends[i] - ends[other]);
          expected += onPlane(i, other);
        }
      const double ratio = expected > 0 ? apart / expected : 1;
      const double found =
          (static_cast<double>(star[i].walkedMm) - innerMm) / (distanceMm - innerMm);
      places_[first + i].weight =
          static_cast<float>(std::clamp(ratio, 0.0, 2.0) * std::clamp(found, 0.0, 1.0));
    }
  }

  std::vector<shared::FarPlace> take() { return std::move(places_); }

 private:
  shared::FarPlace placeOf(const atlas::SurfacePoint& point) const {
    if (point.triangle == atlas::SurfacePoint::nowhere) return {0, 0, 0};
    const std::array<int, 2>& shift = cells_.shiftOfChart[atlas_.chartOfTriangle[point.triangle]];
    std::array<float, 2> place{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      float uv = 0;
      for (std::size_t i = 0; i < 3; ++i)
        uv += point.barycentric[i] * atlas_.vertices[atlas_.triangles[point.triangle][i]].uv[axis];
      place[axis] = (uv * static_cast<float>(mapSize_) + static_cast<float>(shift[axis])) /
                    static_cast<float>(cells_.size);
    }
    return {place[0], place[1], 0};
  }

  glm::dvec3 positionOf(const atlas::SurfacePoint& point) const {
    glm::dvec3 position(0);
    if (point.triangle == atlas::SurfacePoint::nowhere) return position;
    const Triangle& triangle = surface_.triangles[point.triangle];
    for (std::size_t i = 0; i < 3; ++i)
      position += static_cast<double>(point.barycentric[i]) *
                  glm::dvec3(glm::make_vec3(surface_.positionsMm[triangle[i]].data()));
    return position;
  }

  const core::RestSurface& surface_;
  const atlas::Atlas& atlas_;
  const atlas::Neighbourhoods& cells_;
  int mapSize_;
  std::vector<shared::FarPlace> places_;
};

std::vector<shared::FarPlace> farPlaces(const RestScene& scene, const FlatScene& flat,
                                        const PatternLayout& layout) {
  const core::RestSurface& surface = scene.surface;
  const double texelMm = flat.texelEdgeMm();
  std::vector<double> innerMm(surface.positionsMm.size(), 0);
  std::vector<double> distanceMm(surface.positionsMm.size(), 0);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const std::uint32_t medium = scene.mediumOfObject[surface.objectOfTriangle[t]];
    const PatternExtent& extent = layout.extentOfMedium[medium];
    for (const std::uint32_t vertex : surface.triangles[t]) {
      innerMm[vertex] = extent.blockRadius() * texelMm;
      distanceMm[vertex] = extent.distance * texelMm;
    }
  }
  FarPlacer placer(surface, flat.atlas, layout.maps.distant,
                   static_cast<int>(layout.maps.distantMapSize));
  const std::vector<atlas::GeodesicStar> stars = atlas::walkFromVertices(surface, distanceMm);
  for (std::size_t i = 0; i < stars.size(); ++i) placer.add(stars[i], innerMm[i], distanceMm[i]);
  return placer.take();
}

}  // namespace

PatternLayout layOutPattern(const RestScene& scene, const FlatScene& flat,
                            const PatternOptions& options) {
  const int mapSize = flat.mapSize;
  // Aprons take room. Where they would need more than this, the pattern shrinks. Every device reads
  // 32 million texels from one buffer.
  const int largest = std::min(std::max(2 * mapSize, 1024), 5632);
  const double texelMm = flat.texelEdgeMm();
  PatternLayout layout;
  int nearReach = 1;
  int cell = mapSize;
  for (std::size_t i = 0; i < scene.media.size(); ++i) {
    const double freePathMm = bssrdf::shortestMeanFreePathMm(scene.media[i]);
    const PatternExtent extent =
        patternExtent({.nearRings = options.nearRings,
                       .nearSpacingMm = static_cast<double>(options.nearSpacing) * freePathMm,
                       .farDistanceMm = static_cast<double>(options.farDistance) * freePathMm},
                      texelMm, smallestAreaMm2(scene, i));
    layout.extentOfMedium.push_back(extent);
    nearReach = std::max(nearReach, extent.nearReach());
    cell = std::min(cell, extent.cell);
  }
  layout.maps.nearby = atlas::makeNeighbourhoods(
      scene.surface, flat.atlas,
      {.mapSize = mapSize, .reach = nearReach, .alignment = 1, .maxSize = largest});

  // Means over cells need no more than about 8² texels each.
  int coarseness = 1;
  while (cell / coarseness >= 16) coarseness *= 2;
  const int distantMapSize = std::max(1, mapSize / coarseness);
  const int coarseCell = std::max(1, cell * distantMapSize / mapSize);
  layout.maps.distant = atlas::makeNeighbourhoods(scene.surface, flat.atlas,
                                                  {.mapSize = distantMapSize,
                                                   .reach = 2 * coarseCell + 1,
                                                   .alignment = coarseCell,
                                                   .maxSize = largest});
  layout.maps.distantMapSize = static_cast<std::uint32_t>(distantMapSize);
  layout.maps.cellEdge = static_cast<std::uint32_t>(coarseCell);
  for (PatternExtent& extent : layout.extentOfMedium)
    extent = fitted(extent, layout.maps.nearby.reach);
  layout.maps.texelAreas = atlas::texelAreas(flat.atlas, mapSize);
  layout.maps.farPlaces = farPlaces(scene, flat, layout);
  return layout;
}

}  // namespace opaline::paper
