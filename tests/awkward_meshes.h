#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "opaline/types.h"

namespace opaline::awkward {

struct Shape {
  std::string name;
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> objects;  // empty: one object
};

inline std::uint32_t addVertex(Shape& shape, double x, double y, double z) {
  shape.positions.push_back({static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
  return static_cast<std::uint32_t>(shape.positions.size() - 1);
}

/// A grid of quads over [0,1]², placed in space by `place(u, v)`; nothing is shared across its rim.
template <typename Place>
void addGrid(Shape& shape, int columns, int rows, const Place& place) {
  const auto first = static_cast<std::uint32_t>(shape.positions.size());
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const Vec3 p = place(static_cast<double>(i) / columns, static_cast<double>(j) / rows);
      shape.positions.push_back(p);
    }
  }
  const auto at = [&](int i, int j) {
    return first + static_cast<std::uint32_t>(j * (columns + 1) + i);
  };
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      shape.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      shape.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
}

inline Vec3 vec(double x, double y, double z) {
  return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

/// Adds 0 so that a seam's two sides agree in every bit.
inline double turn(double part) {
  return 2 * std::numbers::pi * (part >= 1 ? 0 : part);
}

inline Shape empty() {
  return {"empty", {}, {}, {}};
}

inline Shape oneTriangle() {
  return {"one_triangle", {{0, 0, 0}, {3, 0, 0}, {0, 1, 1}}, {{0, 1, 2}}, {}};
}

inline Shape flatSheet() {
  Shape shape{"flat_sheet", {}, {}, {}};
  addGrid(shape, 30, 20, [](double u, double v) { return vec(3 * u, 0, -2 * v); });
  return shape;
}

inline Shape openSheet() {
  Shape shape{"open_sheet", {}, {}, {}};
  addGrid(shape, 40, 40, [](double u, double v) {
    return vec(4 * u, .4 * std::sin(9 * u) * std::cos(7 * v), -4 * v);
  });
  return shape;
}

inline Shape sphere(const std::string& name = "sphere", int columns = 48, int rows = 24) {
  Shape shape{name, {}, {}, {}};
  addGrid(shape, columns, rows, [](double u, double v) {
    const double polar = std::numbers::pi * v;
    const double ring = v <= 0 || v >= 1 ? 0 : std::sin(polar);
    return vec(ring * std::cos(turn(u)), -std::cos(polar), -ring * std::sin(turn(u)));
  });
  return shape;  // triangles at the poles are degenerate
}

inline Shape torus() {
  Shape shape{"torus", {}, {}, {}};
  addGrid(shape, 60, 30, [](double u, double v) {
    const double ring = 2 + .7 * std::cos(turn(v));
    return vec(ring * std::cos(turn(u)), .7 * std::sin(turn(v)), -ring * std::sin(turn(u)));
  });
  return shape;
}

inline Shape moebiusStrip() {
  Shape shape{"moebius_strip", {}, {}, {}};
  addGrid(shape, 80, 6, [](double u, double v) {
    const double half = u >= 1 ? 0 : std::numbers::pi * u;
    const double across = (u >= 1 ? -1 : 1) * (v - .5);
    const double ring = 2 + across * std::cos(half);
    return vec(ring * std::cos(turn(u)), across * std::sin(half), ring * std::sin(turn(u)));
  });
  return shape;
}

/// Twelve long thin tubes that meet in the middle.
inline Shape thinLimbs() {
  Shape shape{"thin_limbs", {}, {}, {}};
  for (int limb = 0; limb < 12; ++limb) {
    const double angle = turn(limb / 12.0);
    addGrid(shape, 80, 8, [&](double u, double v) {
      const double along = .4 + 10 * u;
      const double y = .08 * std::cos(turn(v));
      const double side = .08 * std::sin(turn(v));
      return vec(along * std::cos(angle) - side * std::sin(angle), y,
                 along * std::sin(angle) + side * std::cos(angle));
    });
  }
  return shape;
}

/// Five sheets that share one edge.
inline Shape edgeFan() {
  Shape shape{"edge_fan", {}, {}, {}};
  const std::uint32_t a = addVertex(shape, 0, 0, 0);
  const std::uint32_t b = addVertex(shape, 0, 1, 0);
  for (int i = 0; i < 5; ++i) {
    const std::uint32_t c = addVertex(shape, std::cos(turn(i / 5.0)), .5, std::sin(turn(i / 5.0)));
    shape.triangles.push_back({a, b, c});
  }
  return shape;
}

inline Shape manyComponents() {
  Shape shape{"many_components", {}, {}, {}};
  for (int k = 0; k < 400; ++k) {
    const int row = k / 20;
    const double x = k - 20 * row;
    const double z = row;
    const double size = .1 + .002 * k;
    const std::uint32_t a = addVertex(shape, x, 0, z);
    const std::uint32_t b = addVertex(shape, x + size, 0, z);
    const std::uint32_t c = addVertex(shape, x, size, z);
    const std::uint32_t d = addVertex(shape, x, 0, z + size);
    for (const Triangle& t : {Triangle{a, c, b}, {a, b, d}, {a, d, c}, {b, c, d}}) {
      shape.triangles.push_back(t);
    }
  }
  return shape;
}

/// Slivers, points and lines among sound triangles.
inline Shape degenerates() {
  Shape shape = openSheet();
  shape.name = "degenerates";
  const auto count = static_cast<std::uint32_t>(shape.positions.size());
  for (std::uint32_t i = 0; i + 2 < count; i += 37) {
    shape.triangles.insert(shape.triangles.begin() + i, {i, i, i + 1});
  }
  shape.triangles.push_back({5, 5, 5});
  const std::uint32_t a = addVertex(shape, 9, 9, 9);
  const std::uint32_t b = addVertex(shape, 10, 10, 10);
  const std::uint32_t c = addVertex(shape, 11, 11, 11);
  const std::uint32_t d = addVertex(shape, 10, 10.0005, 10);
  shape.triangles.push_back({a, b, c});
  shape.triangles.push_back({a, d, c});
  return shape;
}

inline Shape onlyDegenerate() {
  return {"only_degenerate", {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}, {1, 1, 1}}, {}};
}

/// Every face twice, once with either orientation for half of them.
inline Shape coincidentFaces() {
  Shape shape = sphere("coincident_faces", 24, 12);
  const std::vector<Triangle> once = shape.triangles;
  for (std::size_t i = 0; i < once.size(); ++i) {
    const auto& [a, b, c] = once[i];
    shape.triangles.push_back(i % 2 == 0 ? Triangle{a, b, c} : Triangle{a, c, b});
  }
  return shape;
}

/// One sheet whose halves belong to different objects.
inline Shape twoObjects() {
  Shape shape = openSheet();
  shape.name = "two_objects";
  for (std::size_t i = 0; i < shape.triangles.size(); ++i) {
    shape.objects.push_back(i < shape.triangles.size() / 2 ? 0 : 1);
  }
  return shape;
}

/// Two triangles of the same vertices, back to back: a closed surface without an inside.
inline Shape backToBack() {
  return {"back_to_back", {{0, 0, 0}, {3, 0, 0}, {0, 1, 1}}, {{0, 1, 2}, {0, 2, 1}}, {}};
}

/// Eight vertices of which seven lie as near to each other as floats can, under five faces whose
/// centroids agree.
inline Shape nearlyOnePoint() {
  Shape shape{"nearly_one_point", {}, {}, {}};
  const float next = std::nextafter(1.0F, 2.0F);
  for (unsigned corner = 0; corner < 7; ++corner) {
    shape.positions.push_back({(corner & 1U) != 0 ? next : 1.0F, (corner & 2U) != 0 ? next : 1.0F,
                               (corner & 4U) != 0 ? next : 1.0F});
  }
  shape.positions.push_back({50, 40, 30});
  shape.triangles = {{0, 1, 2}, {0, 2, 1}, {1, 3, 7}, {3, 1, 7}, {4, 5, 6}};
  return shape;
}

/// Triangles at random between few places, most of which differ by roundings.
inline Shape dust(unsigned seed) {
  Shape shape{"dust_" + std::to_string(seed), {}, {}, {}};
  std::minstd_rand random(seed + 1);
  const auto upTo = [&](unsigned count) {
    return static_cast<std::uint32_t>(random() >> 8U) % count;
  };
  const std::uint32_t vertices = 3 + upTo(10);
  for (std::uint32_t v = 0; v < vertices; ++v) {
    Vec3 place{1, 1, 1};
    if (upTo(6) == 0) place = {1, static_cast<float>(1 + upTo(4)), static_cast<float>(upTo(3))};
    for (float& x : place) {
      for (std::uint32_t steps = upTo(3); steps > 0; --steps) x = std::nextafter(x, 9.0F);
    }
    shape.positions.push_back(place);
  }
  for (std::uint32_t t = 2 + upTo(30); t > 0; --t) {
    shape.triangles.push_back({upTo(vertices), upTo(vertices), upTo(vertices)});
  }
  return shape;
}

/// Up to fourteen triangles between few places of small whole numbers: many share places, corners
/// or edges, or lie upon each other in either turn.
inline Shape crumbs(unsigned seed) {
  Shape shape{"crumbs_" + std::to_string(seed), {}, {}, {}};
  std::minstd_rand random(seed + 1);
  const auto upTo = [&](unsigned count) {
    return static_cast<std::uint32_t>(random() >> 8U) % count;
  };
  const std::uint32_t vertices = 3 + upTo(7);
  for (std::uint32_t v = 0; v < vertices; ++v)
    shape.positions.push_back(
        {static_cast<float>(upTo(3)), static_cast<float>(upTo(2)), static_cast<float>(upTo(2))});
  const std::uint32_t shared = upTo(3);  // corners that all triangles have in common
  for (std::uint32_t t = 1 + upTo(14); t > 0; --t) {
    Triangle triangle = {0, 1, upTo(vertices)};
    for (std::uint32_t i = shared; i < 2; ++i) triangle[i] = upTo(vertices);
    shape.triangles.push_back(triangle);
    if (upTo(3) == 0) shape.triangles.push_back({triangle[2], triangle[1], triangle[0]});
  }
  return shape;
}

/// Needles that share their tip, each beside the next.
inline Shape needleFan(std::uint32_t count) {
  Shape shape{"needle_fan", {}, {}, {}};
  addVertex(shape, 0, 0, 0);
  for (std::uint32_t i = 0; i <= count; ++i) addVertex(shape, 50 + .001 * i, .001 * i, 0);
  for (std::uint32_t i = 1; i <= count; ++i) shape.triangles.push_back({0, i, i + 1});
  return shape;
}

/// A flat star of so many points, from its centre.
inline Shape star(std::uint32_t points) {
  Shape shape{"star", {}, {}, {}};
  addVertex(shape, 0, 0, 0);
  for (std::uint32_t i = 0; i < 2 * points; ++i) {
    const double angle = turn(i / (2.0 * points));
    const double radius = i % 2 == 0 ? 1 : .5;
    addVertex(shape, radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  for (std::uint32_t i = 0; i < 2 * points; ++i)
    shape.triangles.push_back({0, 1 + i, 1 + (i + 1) % (2 * points)});
  return shape;
}

inline std::vector<Shape> all() {
  return {empty(),      oneTriangle(),     flatSheet(),    openSheet(),
          sphere(),     torus(),           moebiusStrip(), thinLimbs(),
          edgeFan(),    manyComponents(),  degenerates(),  onlyDegenerate(),
          twoObjects(), coincidentFaces(), backToBack(),   nearlyOnePoint()};
}

}  // namespace opaline::awkward
