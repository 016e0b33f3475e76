#include "paper/atlas/texel_area.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace opaline::atlas {

namespace {

struct Point {
  double x;
  double y;
};

// A triangle clipped by the four sides of a texel has at most seven corners.
struct Polygon {
  std::array<Point, 8> corners;
  std::size_t count = 0;

  void add(const Point& corner) { corners[count++] = corner; }
};

// Sutherland and Hodgman 1974: the part where inside(corner) ≥ 0, for a linear function.
template <typename Inside>
Polygon clip(const Polygon& polygon, const Inside& inside) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Point& a = polygon.corners[i];
    const Point& b = polygon.corners[(i + 1) % polygon.count];
    const double da = inside(a);
    const double db = inside(b);
    if (da >= 0) kept.add(a);
    if ((da >= 0) != (db >= 0)) {
      const double t = da / (da - db);
      kept.add({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }
  }
  return kept;
}

// Adds a polygon's area and moment about a point.
void addPolygon(const Polygon& polygon, const Point& centre, TexelArea& sum) {
  for (std::size_t i = 1; i + 1 < polygon.count; ++i) {
    const Point& o = polygon.corners[0];
    const Point& a = polygon.corners[i];
    const Point& b = polygon.corners[i + 1];
    const double area = 0.5 * std::abs((a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x));
    sum.area += static_cast<float>(area);
    sum.moment[0] += static_cast<float>(area * ((o.x + a.x + b.x) / 3 - centre.x));
    sum.moment[1] += static_cast<float>(area * ((o.y + a.y + b.y) / 3 - centre.y));
  }
}

int texelOf(double place, int mapSize) {
  return static_cast<int>(std::clamp(std::floor(place), 0.0, mapSize - 1.0));
}

// Adds a triangle, in texels, row by row.
void addTriangle(const Polygon& triangle, int mapSize, std::vector<TexelArea>& areas) {
  const auto byY = [](const Point& a, const Point& b) { return a.y < b.y; };
  const auto byX = [](const Point& a, const Point& b) { return a.x < b.x; };
  const auto [top, bottom] =
      std::minmax_element(triangle.corners.begin(), triangle.corners.begin() + 3, byY);
  for (int y = texelOf(top->y, mapSize); y <= texelOf(bottom->y, mapSize); ++y) {
    const Polygon row = clip(clip(triangle, [&](const Point& p) { return p.y - y; }),
                             [&](const Point& p) { return y + 1 - p.y; });
    if (row.count < 3) continue;
    const auto [left, right] = std::minmax_element(
        row.corners.begin(), row.corners.begin() + static_cast<std::ptrdiff_t>(row.count), byX);
    for (int x = texelOf(left->x, mapSize); x <= texelOf(right->x, mapSize); ++x) {
      const Polygon cell = clip(clip(row, [&](const Point& p) { return p.x - x; }),
                                [&](const Point& p) { return x + 1 - p.x; });
      addPolygon(cell, {x + 0.5, y + 0.5},
                 areas[static_cast<std::size_t>(y) * static_cast<std::size_t>(mapSize) +
                       static_cast<std::size_t>(x)]);
    }
  }
}

}  // namespace

std::vector<TexelArea> texelAreas(const Atlas& atlas, int mapSize) {
  std::vector<TexelArea> areas(static_cast<std::size_t>(mapSize) *
                               static_cast<std::size_t>(mapSize));
  for (const Triangle& triangle : atlas.triangles) {
    Polygon polygon;
    for (const std::uint32_t corner : triangle) {
      const Vec2& uv = atlas.vertices[corner].uv;
      polygon.add({static_cast<double>(uv[0]) * mapSize, static_cast<double>(uv[1]) * mapSize});
    }
    addTriangle(polygon, mapSize, areas);
  }
  return areas;
}

}  // namespace opaline::atlas
