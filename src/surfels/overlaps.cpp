#include "surfels/overlaps.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include "core/disjoint_sets.h"
#include "core/equal_positions.h"
#include "core/half_edges.h"

namespace opaline::surfels {

namespace {

// How far in front of the surface the medium has to go on, in diagonals of the body.
constexpr double reach = 1e-4;

// The most pairs of boxes that are compared. With more parts than that allows, any place may lie in
// another part.
constexpr std::size_t mostPairs = 4'000'000;

// For every triangle the number of its part. Triangles hang together at edges that only the two of
// them have, so boxes side by side are parts of their own.
std::vector<std::uint32_t> partsOf(const core::RestSurface& surface) {
  const std::vector<Triangle> joined =
      core::renamed(surface.triangles, core::equalPositions(surface.positionsMm));
  core::DisjointSets sets(joined.size());
  core::forEachEdge(core::sortedHalfEdges(joined), [&](std::span<const core::HalfEdge> edge) {
    if (edge.size() == 2) sets.join(edge[0].triangle, edge[1].triangle);
  });
  std::vector<std::uint32_t> parts;
  parts.reserve(joined.size());
  for (std::uint32_t t = 0; t < joined.size(); ++t) parts.push_back(sets.find(t));
  return parts;
}

}  // namespace

// Looks for boxes that meet, from low x to high.
class Overlaps::Finder {
 public:
  Finder(const core::RestSurface& surface, const std::vector<bool>& boundsMedium,
         std::span<const std::uint32_t> partOfTriangle) {
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
      if (!boundsMedium[t]) continue;
      Part& part = parts_[partOfTriangle[t]];
      part.object = surface.objectOfTriangle[t];
      for (const std::uint32_t vertex : surface.triangles[t])
        part.box.include(vectorOf(surface.positionsMm[vertex]));
    }
    std::vector<Part*> order;
    for (auto& [number, part] : parts_) order.push_back(&part);
    std::sort(order.begin(), order.end(), [](const Part* a, const Part* b) {
      return std::pair(a->object, a->box.low) < std::pair(b->object, b->box.low);
    });
    if (!compare(order))
      for (Part* part : order) part->others = {part->box};
  }

  std::map<std::uint32_t, Part> withOthers() && {
    std::erase_if(parts_, [](const auto& part) { return part.second.others.empty(); });
    return std::move(parts_);
  }

 private:
  static bool compare(std::span<Part* const> order) {
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
      Part& part = *order[i];
      for (std::size_t k = i + 1; k < order.size(); ++k) {
        Part& other = *order[k];
        if (other.object != part.object || other.box.low[0] > part.box.high[0]) break;
        if (++pairs > mostPairs) return false;
        if (!part.box.meets(other.box)) continue;
        part.others.push_back(other.box);
        other.others.push_back(part.box);
      }
    }
    return true;
  }

  std::map<std::uint32_t, Part> parts_;
};

Overlaps::Overlaps(const core::RestSurface& surface, const std::vector<bool>& boundsMedium) {
  partOfTriangle_ = partsOf(surface);
  parts_ = Finder(surface, boundsMedium, partOfTriangle_).withOthers();
  std::map<std::uint32_t, std::vector<std::uint32_t>> trianglesOfBody;
  for (const auto& [number, part] : parts_) trianglesOfBody[part.object];
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    if (const auto body = trianglesOfBody.find(surface.objectOfTriangle[t]);
        boundsMedium[t] && body != trianglesOfBody.end())
      body->second.push_back(t);
  for (const auto& [object, triangles] : trianglesOfBody)
    bodies_.emplace(object, WindingNumber(surface, triangles));
}

bool Overlaps::isWithin(std::uint32_t triangle, const Vector& placeMm, const Vector& normal) const {
  if (!any()) return false;
  const auto part = parts_.find(partOfTriangle_[triangle]);
  if (part == parts_.end()) return false;
  const WindingNumber& body = bodies_.at(part->second.object);
  Vector before = placeMm;
  addTimes(reach * body.box().diagonal(), normal, before);
  return std::any_of(part->second.others.begin(), part->second.others.end(),
                     [&](const Box& other) { return other.contains(placeMm); }) &&
         body.isInside(before);
}

}  // namespace opaline::surfels
