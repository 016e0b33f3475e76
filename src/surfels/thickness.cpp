#include "surfels/thickness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "surfels/box.h"
#include "surfels/vector.h"

namespace opaline::surfels {

namespace {

// The most nodes that a ray visits; usual bodies take up to 200. Where thousands of long thin parts
// lie upon each other, all of their boxes overlap.
constexpr int mostNodesOfRay = 500;

struct Ray {
  Vector origin;
  Vector direction;    // unit
  std::uint32_t from;  // triangle that it leaves
};

// Sends rays through the tree of surfels.
class Tracer {
 public:
  Tracer(const core::RestSurface& surface, const SurfelDivision& surfels)
      : surface_(surface), surfels_(surfels) {
    boxes_.resize(surfels.tree.links.size());
    for (std::size_t object = 0; object + 1 < surfels.tree.rootOfObject.size(); ++object) {
      for (std::uint32_t node = surfels.tree.rootOfObject[object];
           node < surfels.tree.rootOfObject[object + 1]; node = enclose(node)) {
      }
    }
  }

  // The thickness measured inwards from the middle of a surfel's first piece.
  double thicknessUnder(std::uint32_t surfel) {
    const Piece& piece = surfels_.pieces[std::size_t{surfel} * surfels_.piecesPerSurfel];
    const std::array<Vector, 3> corners = cornersOf(piece.triangle);
    const Vector along = difference(corners[1], corners[0]);
    const Vector across = difference(corners[2], corners[0]);
    const Vector outwards = cross(along, across);
    const double length = lengthOf(outwards);
    if (!(length > 0)) return std::numeric_limits<double>::infinity();
    double v = 0;
    double w = 0;
    for (const std::array<float, 2>& corner : piece.corners) {
      v += static_cast<double>(corner[0]) / 3;
      w += static_cast<double>(corner[1]) / 3;
    }
    Ray ray{.origin = corners[0], .direction = {}, .from = piece.triangle};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ray.origin[axis] += v * along[axis] + w * across[axis];
      ray.direction[axis] = -outwards[axis] / length;
    }
    return nearest(ray, surface_.objectOfTriangle[piece.triangle]);
  }

 private:
  std::array<Vector, 3> cornersOf(std::uint32_t triangle) const {
    std::array<Vector, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = vectorOf(surface_.positionsMm[surface_.triangles[triangle][i]]);
    return corners;
  }

  std::span<const Piece> piecesOf(const NodeLink& leaf) const {
    const std::size_t pieces = surfels_.piecesPerSurfel;
    return std::span(surfels_.pieces).subspan(leaf.first * pieces, leaf.count * pieces);
  }

  // Includes only the piece, not all of its triangle: with few large triangles, every leaf's box
  // would be as large as the body's.
  void include(const Piece& piece, Box& box) const {
    const std::array<Vector, 3> corners = cornersOf(piece.triangle);
    for (const std::array<float, 2>& corner : piece.corners) {
      const auto v = static_cast<double>(corner[0]);
      const auto w = static_cast<double>(corner[1]);
      Vector place{};
      for (std::size_t axis = 0; axis < 3; ++axis)
        place[axis] = (1 - v - w) * corners[0][axis] + v * corners[1][axis] + w * corners[2][axis];
      box.include(place);
    }
  }

  // Returns the node after all those below it.
  std::uint32_t enclose(std::uint32_t node) {
    const NodeLink link = linkOf(surfels_.tree, node);
    Box box;
    if (link.leaf) {
      for (const Piece& piece : piecesOf(link)) include(piece, box);
    } else {
      for (std::uint32_t child = node + 1; child < link.end;) {
        const std::uint32_t next = enclose(child);
        box.include(boxes_[child]);
        child = next;
      }
    }
    boxes_[node] = box;
    return link.end;
  }

  // The distance at which the ray enters the box; nothing if it misses.
  static std::optional<double> entryOf(const Ray& ray, const Box& box) {
    double near = 0;
    double far = std::numeric_limits<double>::infinity();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double over = 1 / ray.direction[axis];
      double first = (box.low[axis] - ray.origin[axis]) * over;
      double second = (box.high[axis] - ray.origin[axis]) * over;
      if (first > second) std::swap(first, second);
      if (first > near) near = first;  // keeps the old value if the new one is NaN
      if (second < far) far = second;
    }
    return near <= far ? std::optional(near) : std::nullopt;
  }

  // Distance to a triangle by Möller and Trumbore 1997.
  std::optional<double> meet(const Ray& ray, std::uint32_t triangle) const {
    if (triangle == ray.from) return {};
    const std::array<Vector, 3> corners = cornersOf(triangle);
    const Vector along = difference(corners[1], corners[0]);
    const Vector across = difference(corners[2], corners[0]);
    const Vector p = cross(ray.direction, across);
    const double determinant = dot(along, p);
    if (determinant == 0) return {};
    const Vector to = difference(ray.origin, corners[0]);
    const double u = dot(to, p) / determinant;
    const Vector q = cross(to, along);
    const double v = dot(ray.direction, q) / determinant;
    const double distance = dot(across, q) / determinant;
    if (!(u >= 0 && v >= 0 && u + v <= 1 && distance > 0)) return {};
    return distance;
  }

  struct Waiting {
    double entry;
    std::uint32_t node;
  };

  // Adds the children that the ray meets, the nearest last.
  void addChildren(const Ray& ray, std::uint32_t node, std::uint32_t end) {
    const auto first = static_cast<std::ptrdiff_t>(waiting_.size());
    for (std::uint32_t child = node; child < end;) {
      if (const std::optional<double> entry = entryOf(ray, boxes_[child]))
        waiting_.push_back({*entry, child});
      const NodeLink link = linkOf(surfels_.tree, child);
      child = link.leaf ? child + 1 : link.end;
    }
    std::stable_sort(waiting_.begin() + first, waiting_.end(),
                     [](const Waiting& a, const Waiting& b) { return a.entry > b.entry; });
  }

  // Near nodes are visited first, so the result is the nearest surface unless too many nodes meet
  // the ray.
  double nearest(const Ray& ray, std::uint32_t object) {
    double distance = std::numeric_limits<double>::infinity();
    waiting_.clear();
    addChildren(ray, surfels_.tree.rootOfObject[object], surfels_.tree.rootOfObject[object + 1]);
    for (int nodes = 0; !waiting_.empty() && nodes < mostNodesOfRay; ++nodes) {
      const Waiting next = waiting_.back();
      waiting_.pop_back();
      if (next.entry > distance) continue;
      const NodeLink link = linkOf(surfels_.tree, next.node);
      if (link.leaf)
        for (const Piece& piece : piecesOf(link))
          distance = std::min(distance, meet(ray, piece.triangle).value_or(distance));
      else
        addChildren(ray, next.node + 1, link.end);
    }
    return distance;
  }

  const core::RestSurface& surface_;
  const SurfelDivision& surfels_;
  std::vector<Box> boxes_;
  std::vector<Waiting> waiting_;
};

}  // namespace

std::vector<double> thicknessMm(const core::RestSurface& surface, const SurfelDivision& surfels) {
  Tracer tracer(surface, surfels);
  std::vector<double> thickness(surfels.count());
  for (std::uint32_t node = 0; node < surfels.tree.links.size(); ++node) {
    const NodeLink link = linkOf(surfels.tree, node);
    if (!link.leaf) continue;
    const double mm = tracer.thicknessUnder(link.first);
    std::fill_n(thickness.begin() + link.first, link.count, mm);
  }
  return thickness;
}

}  // namespace opaline::surfels
