#include "surfels/subdivision.h"

#include <algorithm>
#include <cmath>

namespace opaline::surfels {

namespace {

using Point = std::array<double, 3>;

double squaredDistance(const Point& a, const Point& b) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

Point middleOf(const Point& a, const Point& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

struct Corner {
  Point place;
  std::array<double, 2> barycentric;
};

struct Part {
  std::array<Corner, 3> corners;
  double fraction = 1;

  /// The squared length of the edge opposite each corner.
  std::array<double, 3> squaredEdges() const {
    return {squaredDistance(corners[1].place, corners[2].place),
            squaredDistance(corners[2].place, corners[0].place),
            squaredDistance(corners[0].place, corners[1].place)};
  }
};

Part wholeTriangle(const core::RestSurface& surface, std::uint32_t triangle) {
  constexpr std::array<std::array<double, 2>, 3> barycentric{{{0, 0}, {1, 0}, {0, 1}}};
  Part part;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& position = surface.positionsMm[surface.triangles[triangle][i]];
    part.corners[i] = {{double{position[0]}, double{position[1]}, double{position[2]}},
                       barycentric[i]};
  }
  return part;
}

double squaredSpacing(const std::array<double, 3>& squaredEdges) {
  return (squaredEdges[0] + squaredEdges[1] + squaredEdges[2]) / 6;
}

Piece pieceOf(std::uint32_t triangle, const Part& part) {
  Piece piece{.triangle = triangle, .fraction = static_cast<float>(part.fraction)};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t axis = 0; axis < 2; ++axis)
      piece.corners[i][axis] = static_cast<float>(part.corners[i].barycentric[axis]);
  }
  return piece;
}

// The two halves on either side of the middle of the longest edge.
std::array<Part, 2> bisect(const Part& part, const std::array<double, 3>& squaredEdges) {
  const auto apex = static_cast<std::size_t>(
      std::max_element(squaredEdges.begin(), squaredEdges.end()) - squaredEdges.begin());
  const std::size_t first = (apex + 1) % 3;
  const std::size_t second = (apex + 2) % 3;
  Corner middle;
  middle.place = middleOf(part.corners[first].place, part.corners[second].place);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    middle.barycentric[axis] =
        (part.corners[first].barycentric[axis] + part.corners[second].barycentric[axis]) / 2;
  }
  std::array<Part, 2> halves{part, part};
  halves[0].corners[second] = middle;
  halves[1].corners[first] = middle;
  for (Part& half : halves) half.fraction /= 2;
  return halves;
}

}  // namespace

std::array<double, 3> crossOf(const core::RestSurface& surface, std::uint32_t triangle) {
  const Triangle& t = surface.triangles[triangle];
  std::array<std::array<double, 3>, 2> edges{};
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      edges[i][axis] =
          double{surface.positionsMm[t[i + 1]][axis]} - double{surface.positionsMm[t[0]][axis]};
    }
  }
  const auto& [a, b] = edges;
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vec3 middleOfMm(const core::RestSurface& surface, const Piece& piece) {
  const Triangle& triangle = surface.triangles[piece.triangle];
  const Vec3& a = surface.positionsMm[triangle[0]];
  const Vec3& b = surface.positionsMm[triangle[1]];
  const Vec3& c = surface.positionsMm[triangle[2]];
  float v = 0;
  float w = 0;
  for (const std::array<float, 2>& corner : piece.corners) {
    v += corner[0] / 3;
    w += corner[1] / 3;
  }
  Vec3 place{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    place[axis] = (1 - v - w) * a[axis] + v * b[axis] + w * c[axis];
  return place;
}

double areaMm2(const core::RestSurface& surface, std::uint32_t triangle) {
  const std::array<double, 3> cross = crossOf(surface, triangle);
  return std::hypot(cross[0], cross[1], cross[2]) / 2;
}

double areaMm2(const core::RestSurface& surface, const Piece& piece) {
  return static_cast<double>(piece.fraction) * areaMm2(surface, piece.triangle);
}

double spacingOfMm(const core::RestSurface& surface, std::uint32_t triangle) {
  return std::sqrt(squaredSpacing(wholeTriangle(surface, triangle).squaredEdges()));
}

std::optional<std::vector<Piece>> subdivide(const core::RestSurface& surface,
                                            std::span<const double> spacingOfObjectMm,
                                            std::size_t limit) {
  std::vector<Piece> pieces;
  std::vector<Part> waiting;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    const double spacingMm = spacingOfObjectMm[surface.objectOfTriangle[t]];
    waiting.push_back(wholeTriangle(surface, t));
    while (!waiting.empty()) {
      const Part part = waiting.back();
      waiting.pop_back();
      const std::array<double, 3> squaredEdges = part.squaredEdges();
      if (squaredSpacing(squaredEdges) > spacingMm * spacingMm) {
        for (const Part& half : bisect(part, squaredEdges)) waiting.push_back(half);
      } else {
        pieces.push_back(pieceOf(t, part));
      }
      if (pieces.size() + waiting.size() > limit) return std::nullopt;
    }
  }
  return pieces;
}

std::optional<std::vector<Piece>> subdivideWhere(
    const core::RestSurface& surface, std::uint32_t triangle, double spacingMm, std::size_t limit,
    const std::function<bool(const std::array<std::array<double, 3>, 3>&)>& isOfUse) {
  std::vector<Piece> pieces;
  std::vector<Part> waiting{wholeTriangle(surface, triangle)};
  while (!waiting.empty()) {
    const Part part = waiting.back();
    waiting.pop_back();
    if (!isOfUse({part.corners[0].place, part.corners[1].place, part.corners[2].place})) continue;
    const std::array<double, 3> squaredEdges = part.squaredEdges();
    if (squaredSpacing(squaredEdges) > spacingMm * spacingMm)
      for (const Part& half : bisect(part, squaredEdges)) waiting.push_back(half);
    else
      pieces.push_back(pieceOf(triangle, part));
    if (pieces.size() + waiting.size() > limit) return std::nullopt;
  }
  return pieces;
}

}  // namespace opaline::surfels
