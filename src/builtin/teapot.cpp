// M. Newell, "The utilization of procedure models in digital image synthesis", University of Utah,
// 1975: 32 bicubic Bézier patches, here only the one or two of each part that do not follow by
// symmetry.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "builtin/builtin.h"

namespace opaline::builtin {
namespace {

using Point = std::array<double, 3>;  // x, y up, z
using Patch = std::array<std::array<Point, 4>, 4>;

constexpr int cells = 6;

/// A control point of a profile that turns about the vertical axis. The circle's tangent factor is
/// .56 everywhere except at the knob of the lid.
struct ProfilePoint {
  double radius;
  double height;
  double tangent;
};

using Profile = std::array<ProfilePoint, 4>;

constexpr Profile rim = {
    {{1.4, 2.4, .784}, {1.3375, 2.53125, .749}, {1.4375, 2.53125, .805}, {1.5, 2.4, .84}}};
constexpr Profile upperBody = {
    {{1.5, 2.4, .84}, {1.75, 1.875, .98}, {2, 1.35, 1.12}, {2, .9, 1.12}}};
constexpr Profile lowerBody = {{{2, .9, 1.12}, {2, .45, 1.12}, {1.5, .225, .84}, {1.5, .15, .84}}};
constexpr Profile bottom = {{{1.5, .15, .84}, {1.5, .075, .84}, {1.425, 0, .798}, {0, 0, 0}}};
constexpr Profile knob = {{{0, 3.15, 0}, {.8, 3.15, .45}, {0, 2.85, 0}, {.2, 2.7, .112}}};
constexpr Profile lid = {{{.2, 2.7, .112}, {.4, 2.55, .224}, {1.3, 2.55, .728}, {1.3, 2.4, .728}}};

/// One cross-section of handle or spout: inner and outer point in the plane of symmetry, half
/// width.
struct Section {
  double innerX, innerY, outerX, outerY, halfWidth;
};

using Tube = std::array<Section, 4>;

constexpr Tube upperHandle = {{{-1.6, 2.025, -1.5, 2.25, .3},
                               {-2.3, 2.025, -2.5, 2.25, .3},
                               {-2.7, 2.025, -3, 2.25, .3},
                               {-2.7, 1.8, -3, 1.8, .3}}};
constexpr Tube lowerHandle = {{{-2.7, 1.8, -3, 1.8, .3},
                               {-2.7, 1.575, -3, 1.35, .3},
                               {-2.5, 1.125, -2.65, .9375, .3},
                               {-2, .9, -1.9, .6, .3}}};
constexpr Tube lowerSpout = {{{1.7, 1.425, 1.7, .6, .66},
                              {2.6, 1.425, 3.1, .825, .66},
                              {2.3, 2.1, 2.4, 2.025, .25},
                              {2.7, 2.4, 3.3, 2.4, .25}}};
constexpr Tube upperSpout = {{{2.7, 2.4, 3.3, 2.4, .25},
                              {2.8, 2.475, 3.525, 2.49375, .25},
                              {2.9, 2.475, 3.45, 2.5125, .15},
                              {2.8, 2.4, 3.2, 2.4, .15}}};

/// A quarter turn of a profile that runs downwards on the outside. Rows are along the profile,
/// columns around the axis.
Patch revolved(const Profile& profile, int quarter) {
  constexpr std::array<int, 4> cosine = {1, 0, -1, 0};
  const int c = cosine[static_cast<std::size_t>(quarter)];
  const int s = cosine[static_cast<std::size_t>((quarter + 3) % 4)];
  Patch patch;
  for (std::size_t row = 0; row < 4; ++row) {
    const auto [radius, height, tangent] = profile[row];
    const std::array<std::array<double, 2>, 4> arc = {
        {{radius, 0}, {radius, tangent}, {tangent, radius}, {0, radius}}};
    for (std::size_t column = 0; column < 4; ++column) {
      const auto [x, z] = arc[column];
      patch[row][column] = {c * x - s * z, height, s * x + c * z};
    }
  }
  return patch;
}

/// One half of a tube, on the side of +z or -z.
Patch halfTube(const Tube& tube, int side) {
  Patch patch;
  for (std::size_t row = 0; row < 4; ++row) {
    const Section& section = tube[row];
    const double z = side * section.halfWidth;
    patch[row] = {{{section.innerX, section.innerY, 0},
                   {section.innerX, section.innerY, z},
                   {section.outerX, section.outerY, z},
                   {section.outerX, section.outerY, 0}}};
  }
  return patch;
}

struct PatchInSpace {
  Patch points;
  bool reversed;  // rows × columns point inwards
};

std::vector<PatchInSpace> teapotPatches() {
  std::vector<PatchInSpace> patches;
  for (const Profile* profile : {&rim, &upperBody, &lowerBody, &bottom, &knob, &lid}) {
    for (int quarter = 0; quarter < 4; ++quarter) {
      patches.push_back({revolved(*profile, quarter), true});
    }
  }
  for (const Tube* tube : {&upperHandle, &lowerHandle, &lowerSpout, &upperSpout}) {
    patches.push_back({halfTube(*tube, 1), true});
    patches.push_back({halfTube(*tube, -1), false});
  }
  return patches;
}

std::array<double, 4> bernstein(double t) {
  const double s = 1 - t;
  return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

std::array<double, 4> bernsteinDerivative(double t) {
  const double s = 1 - t;
  return {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t};
}

Point combine(const Patch& patch, const std::array<double, 4>& rows,
              const std::array<double, 4>& columns) {
  Point sum{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        sum[axis] += rows[i] * columns[j] * patch[i][j][axis];
      }
    }
  }
  return sum;
}

Point normalAt(const PatchInSpace& patch, double u, double v) {
  // At a pole the patch's columns meet and the product of its tangents vanishes; its limit from
  // inside does not.
  constexpr double inset = 1e-6;
  u = std::fmin(std::fmax(u, inset), 1 - inset);
  const Point a = combine(patch.points, bernsteinDerivative(u), bernstein(v));
  const Point b = combine(patch.points, bernstein(u), bernsteinDerivative(v));
  Point n = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  const double length = (patch.reversed ? -1 : 1) * std::hypot(n[0], n[1], n[2]);
  return {n[0] / length, n[1] / length, n[2] / length};
}

/// Vertices that share a position to a millionth of a unit are one.
class Welder {
 public:
  std::uint32_t add(const Point& position, const Point& normal) {
    std::array<std::int64_t, 3> key;
    for (std::size_t axis = 0; axis < 3; ++axis) key[axis] = std::llround(position[axis] * 1e6);
    const auto [place, isNew] =
        vertices_.try_emplace(key, static_cast<std::uint32_t>(positions_.size()));
    if (isNew) {
      positions_.push_back(position);
      normals_.push_back({});
    }
    for (std::size_t axis = 0; axis < 3; ++axis) normals_[place->second][axis] += normal[axis];
    return place->second;
  }

  void store(Mesh& mesh) const {
    for (std::size_t v = 0; v < positions_.size(); ++v) {
      const Point& p = positions_[v];
      const Point& n = normals_[v];
      const double length = std::hypot(n[0], n[1], n[2]);
      mesh.positionsMm.push_back(
          {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
      mesh.normals.push_back({static_cast<float>(n[0] / length), static_cast<float>(n[1] / length),
                              static_cast<float>(n[2] / length)});
    }
  }

 private:
  std::map<std::array<std::int64_t, 3>, std::uint32_t> vertices_;
  std::vector<Point> positions_;
  std::vector<Point> normals_;
};

void addTriangle(Mesh& mesh, Triangle triangle, bool reversed) {
  if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) {
    return;
  }
  if (reversed) std::swap(triangle[1], triangle[2]);
  mesh.triangles.push_back(triangle);
}

}  // namespace

Mesh teapotMesh() {
  Mesh mesh;
  Welder welder;
  for (const PatchInSpace& patch : teapotPatches()) {
    std::array<std::array<std::uint32_t, cells + 1>, cells + 1> grid;
    for (std::size_t i = 0; i <= cells; ++i) {
      for (std::size_t j = 0; j <= cells; ++j) {
        const double u = static_cast<double>(i) / cells;
        const double v = static_cast<double>(j) / cells;
        grid[i][j] =
            welder.add(combine(patch.points, bernstein(u), bernstein(v)), normalAt(patch, u, v));
      }
    }
    for (std::size_t i = 0; i < cells; ++i) {
      for (std::size_t j = 0; j < cells; ++j) {
        addTriangle(mesh, {grid[i][j], grid[i + 1][j], grid[i + 1][j + 1]}, patch.reversed);
        addTriangle(mesh, {grid[i][j], grid[i + 1][j + 1], grid[i][j + 1]}, patch.reversed);
      }
    }
  }
  welder.store(mesh);
  return mesh;
}

}  // namespace opaline::builtin
