#include "renderer/scene/pattern_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>

#include "paper/atlas/geodesic.h"
#include "paper/atlas/texel_area.h"

namespace opaline {

namespace {

// Area of the smallest object of a medium.
double smallestAreaMm2(const SceneResources& resources, std::size_t medium) {
  double smallest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < resources.objects; ++i)
    if (resources.mediumOfObject[i] == medium)
      smallest = std::min(smallest, resources.sizeOfObject[i].areaMm2);
  return smallest;
}

// Finds where far samples lie among the cells and how much surface each stands for.
class FarPlacer {
 public:
  FarPlacer(const SceneResources& resources, const atlas::Neighbourhoods& cells, int mapSize)
      : resources_(resources), cells_(cells), mapSize_(mapSize) {}

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
    const atlas::Atlas& atlas = resources_.atlas;
    const std::array<int, 2>& shift = cells_.shiftOfChart[atlas.chartOfTriangle[point.triangle]];
    std::array<float, 2> place{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      float uv = 0;
      for (std::size_t i = 0; i < 3; ++i)
        uv += point.barycentric[i] * atlas.vertices[atlas.triangles[point.triangle][i]].uv[axis];
      place[axis] = (uv * static_cast<float>(mapSize_) + static_cast<float>(shift[axis])) /
                    static_cast<float>(cells_.size);
    }
    return {place[0], place[1], 0};
  }

  glm::dvec3 positionOf(const atlas::SurfacePoint& point) const {
    glm::dvec3 position(0);
    if (point.triangle == atlas::SurfacePoint::nowhere) return position;
    const Triangle& triangle = resources_.merged->triangles[point.triangle];
    for (std::size_t i = 0; i < 3; ++i)
      position += static_cast<double>(point.barycentric[i]) *
                  glm::dvec3(glm::make_vec3(resources_.merged->positionsMm[triangle[i]].data()));
    return position;
  }

  const SceneResources& resources_;
  const atlas::Neighbourhoods& cells_;
  int mapSize_;
  std::vector<shared::FarPlace> places_;
};

std::vector<shared::FarPlace> farPlaces(const SceneResources& resources,
                                        const PatternLayout& layout, const RenderOptions& options) {
  const scene::MergedMesh& merged = *resources.merged;
  const double texelMm = texelEdgeMm(resources, options);
  std::vector<double> innerMm(merged.positionsMm.size(), 0);
  std::vector<double> distanceMm(merged.positionsMm.size(), 0);
  for (std::size_t t = 0; t < merged.triangles.size(); ++t) {
    const std::uint32_t medium = resources.mediumOfObject[merged.objectOfTriangle[t]];
    const paper::PatternExtent& extent = layout.extentOfMedium[medium];
    for (const std::uint32_t vertex : merged.triangles[t]) {
      innerMm[vertex] = extent.blockRadius() * texelMm;
      distanceMm[vertex] = extent.distance * texelMm;
    }
  }
  FarPlacer placer(resources, layout.maps.distant, static_cast<int>(layout.maps.distantMapSize));
  const std::vector<atlas::GeodesicStar> stars =
      atlas::walkFromVertices(surfaceOf(merged), distanceMm);
  for (std::size_t i = 0; i < stars.size(); ++i) placer.add(stars[i], innerMm[i], distanceMm[i]);
  return placer.take();
}

}  // namespace

double texelEdgeMm(const SceneResources& resources, const RenderOptions& options) {
  return resources.atlas.mmPerUnit / options.dsmSize;
}

PatternLayout layOutPattern(const SceneResources& resources, const RenderOptions& options) {
  // Aprons take room: where they would need more than this, the pattern shrinks. 32 million texels
  // are what every device reads from one buffer.
  const int largest = std::min(std::max(2 * options.dsmSize, 1024), 5632);
  const double texelMm = texelEdgeMm(resources, options);
  PatternLayout layout;
  int nearReach = 1;
  int cell = options.dsmSize;
  for (std::size_t i = 0; i < resources.media.size(); ++i) {
    const double freePathMm = shortestMeanFreePathMm(resources.media[i]);
    const paper::PatternExtent extent = paper::patternExtent(
        {.nearRings = options.pattern.nearRings,
         .nearSpacingMm = static_cast<double>(options.pattern.nearSpacing) * freePathMm,
         .farDistanceMm = static_cast<double>(options.pattern.farDistance) * freePathMm},
        texelMm, smallestAreaMm2(resources, i));
    layout.extentOfMedium.push_back(extent);
    nearReach = std::max(nearReach, extent.nearReach());
    cell = std::min(cell, extent.cell);
  }
  const core::RestSurface surface = surfaceOf(*resources.merged);
  layout.maps.nearby = atlas::makeNeighbourhoods(
      surface, resources.atlas,
      {.mapSize = options.dsmSize, .reach = nearReach, .alignment = 1, .maxSize = largest});

  // Means over cells need no more than about 8² texels each.
  int coarseness = 1;
  while (cell / coarseness >= 16) coarseness *= 2;
  const int distantMapSize = std::max(1, options.dsmSize / coarseness);
  const int coarseCell = std::max(1, cell * distantMapSize / options.dsmSize);
  layout.maps.distant = atlas::makeNeighbourhoods(surface, resources.atlas,
                                                  {.mapSize = distantMapSize,
                                                   .reach = 2 * coarseCell + 1,
                                                   .alignment = coarseCell,
                                                   .maxSize = largest});
  layout.maps.distantMapSize = static_cast<std::uint32_t>(distantMapSize);
  layout.maps.cellEdge = static_cast<std::uint32_t>(coarseCell);
  for (paper::PatternExtent& extent : layout.extentOfMedium)
    extent = paper::fitted(extent, layout.maps.nearby.reach);
  layout.maps.texelAreas = atlas::texelAreas(resources.atlas, options.dsmSize);
  layout.maps.farPlaces = farPlaces(resources, layout, options);
  return layout;
}

}  // namespace opaline
