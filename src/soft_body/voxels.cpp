#include "soft_body/voxels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/possible_position.h"
#include "opaline/error.h"

namespace opaline::soft_body {

namespace {

using Point = std::array<double, 3>;

constexpr std::array<std::uint32_t, 3> axes{0, 1, 2};

struct Box {
  Point low;
  Point high;

  double extent(std::uint32_t axis) const { return high[axis] - low[axis]; }
};

Point toPoint(const Vec3& p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

Box boxOf(std::span<const Vec3> positionsMm, std::span<const Triangle> triangles) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  for (const Triangle& triangle : triangles)
    for (const std::uint32_t v : triangle) {
      if (v >= positionsMm.size())
        throw UsageError(fmt::format("a soft body's triangle has a vertex {}, but there are {}", v,
                                     positionsMm.size()));
      if (!core::isPossible(positionsMm[v]))
        throw UsageError(fmt::format(
            "the position of a soft body's vertex {} is not finite, or beyond 1e18 mm", v));
      const Point p = toPoint(positionsMm[v]);
      for (const std::uint32_t axis : axes) {
        box.low[axis] = std::min(box.low[axis], p[axis]);
        box.high[axis] = std::max(box.high[axis], p[axis]);
      }
    }
  return box;
}

// As many cubes as the box needs. They are a little larger than its longest side demands, so that
// no point lies on their border.
Voxels emptyVoxels(const Box& box, std::uint32_t cells) {
  const double longest = std::max({box.extent(0), box.extent(1), box.extent(2)});
  if (!(longest > 0))
    throw UsageError("a soft body needs an extent, but all its triangles are one point");
  constexpr double slack = 1e-3;  // cells
  Voxels voxels;
  voxels.cellMm = longest / (cells - 2 * slack);
  for (const std::uint32_t axis : axes) {
    const double needed = box.extent(axis) / voxels.cellMm;
    voxels.counts[axis] = std::max(static_cast<std::uint32_t>(std::ceil(needed - 2 * slack)), 1U);
    const double spare = voxels.counts[axis] - needed;
    voxels.originMm[axis] = box.low[axis] - voxels.cellMm * (axis == 1 ? slack : spare / 2);
  }
  voxels.filled.assign(std::size_t{voxels.counts[0]} * voxels.counts[1] * voxels.counts[2], false);
  return voxels;
}

void fillAt(const Point& p, Voxels& voxels) {
  std::array<std::uint32_t, 3> cell{};
  for (const std::uint32_t axis : axes) {
    const double place = (p[axis] - voxels.originMm[axis]) / voxels.cellMm;
    cell[axis] = static_cast<std::uint32_t>(
        std::clamp(place, 0.0, static_cast<double>(voxels.counts[axis] - 1)));
  }
  voxels.filled[voxels.index(cell[0], cell[1], cell[2])] = true;
}

// Marks the cubes of points on the triangle. The points are so dense that at most the tip of a
// triangle in a cube is missed.
void fillTriangle(const Point& a, const Point& b, const Point& c, Voxels& voxels) {
  constexpr double spacing = 0.3;  // cells
  double longest = 0;
  for (const std::uint32_t axis : axes)
    longest = std::max({longest, std::abs(b[axis] - a[axis]), std::abs(c[axis] - b[axis]),
                        std::abs(a[axis] - c[axis])});
  const int steps = std::max(1, static_cast<int>(std::ceil(longest / (spacing * voxels.cellMm))));
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; i + j <= steps; ++j) {
      const double u = static_cast<double>(i) / steps;
      const double v = static_cast<double>(j) / steps;
      Point p;
      for (const std::uint32_t axis : axes)
        p[axis] = a[axis] + u * (b[axis] - a[axis]) + v * (c[axis] - a[axis]);
      fillAt(p, voxels);
    }
}

// Cubes that cannot be reached from outside through empty cubes are inside.
void fillInside(Voxels& voxels) {
  // The search uses a layer of empty cubes around all others.
  const std::array<std::uint32_t, 3> wide{voxels.counts[0] + 2, voxels.counts[1] + 2,
                                          voxels.counts[2] + 2};
  const std::array<std::size_t, 3> strides{1, wide[0], std::size_t{wide[0]} * wide[1]};
  std::vector<bool> outside(strides[2] * wide[2], false);
  const auto isFilled = [&](const std::array<std::uint32_t, 3>& p) {
    for (const std::uint32_t axis : axes)
      if (p[axis] == 0 || p[axis] == wide[axis] - 1) return false;
    return bool{voxels.filled[voxels.index(p[0] - 1, p[1] - 1, p[2] - 1)]};
  };
  std::vector<std::array<std::uint32_t, 3>> open{{0, 0, 0}};
  outside[0] = true;
  while (!open.empty()) {
    const std::array<std::uint32_t, 3> here = open.back();
    open.pop_back();
    for (const std::uint32_t axis : axes)
      for (const bool up : {false, true}) {
        if (here[axis] == (up ? wide[axis] - 1 : 0)) continue;
        std::array<std::uint32_t, 3> next = here;
        next[axis] = up ? here[axis] + 1 : here[axis] - 1;
        const std::size_t place =
            next[0] * strides[0] + next[1] * strides[1] + next[2] * strides[2];
        if (outside[place] || isFilled(next)) continue;
        outside[place] = true;
        open.push_back(next);
      }
  }
  for (std::uint32_t z = 0; z < voxels.counts[2]; ++z)
    for (std::uint32_t y = 0; y < voxels.counts[1]; ++y)
      for (std::uint32_t x = 0; x < voxels.counts[0]; ++x)
        if (!outside[(x + 1) * strides[0] + (y + 1) * strides[1] + (z + 1) * strides[2]])
          voxels.filled[voxels.index(x, y, z)] = true;
}

}  // namespace

Voxels makeVoxels(std::span<const Vec3> positionsMm, std::span<const Triangle> triangles,
                  std::uint32_t cells) {
  if (triangles.empty()) throw UsageError("a soft body needs triangles, but there are none");
  Voxels voxels = emptyVoxels(boxOf(positionsMm, triangles), cells);
  for (const Triangle& t : triangles)
    fillTriangle(toPoint(positionsMm[t[0]]), toPoint(positionsMm[t[1]]), toPoint(positionsMm[t[2]]),
                 voxels);
  fillInside(voxels);
  return voxels;
}

}  // namespace opaline::soft_body
