#include "opaline/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace opaline {

namespace {

// All lengths are in diagonals. The square grid in the middle is wider than the body. Around it lie
// rings, each twice as far out as the one before.
constexpr int cellsAcross = 32;
constexpr double halfOfGrid = 0.8;
constexpr int rings = 10;

struct Plane {
  double middleX;
  double middleZ;
  double y;
  double diagonal;

  Vec3 at(double x, double z) const {
    return {static_cast<float>(middleX + diagonal * x), static_cast<float>(y),
            static_cast<float>(middleZ + diagonal * z)};
  }
};

// Adds the corners of the grid's cells, row after row.
void addGrid(const Plane& plane, Mesh& mesh) {
  constexpr std::uint32_t across = cellsAcross + 1;
  const auto place = [](std::uint32_t i) { return halfOfGrid * (2.0 * i / cellsAcross - 1); };
  for (std::uint32_t row = 0; row < across; ++row)
    for (std::uint32_t column = 0; column < across; ++column)
      mesh.positionsMm.push_back(plane.at(place(column), place(row)));
  for (std::uint32_t row = 0; row < cellsAcross; ++row)
    for (std::uint32_t column = 0; column < cellsAcross; ++column) {
      const std::uint32_t a = row * across + column;
      const std::uint32_t b = a + across;
      mesh.triangles.push_back({a, b, a + 1});
      mesh.triangles.push_back({a + 1, b, b + 1});
    }
}

// The border of the grid, all around, as rows and columns.
std::vector<std::pair<std::uint32_t, std::uint32_t>> borderOfGrid() {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> border;
  for (std::uint32_t i = 0; i < cellsAcross; ++i) border.emplace_back(0, i);
  for (std::uint32_t i = 0; i < cellsAcross; ++i) border.emplace_back(i, cellsAcross);
  for (std::uint32_t i = 0; i < cellsAcross; ++i) border.emplace_back(cellsAcross, cellsAcross - i);
  for (std::uint32_t i = 0; i < cellsAcross; ++i) border.emplace_back(cellsAcross - i, 0);
  return border;
}

void addRings(const Plane& plane, Mesh& mesh) {
  const auto border = borderOfGrid();
  const auto count = static_cast<std::uint32_t>(border.size());
  std::vector<std::uint32_t> inner;
  inner.reserve(count);
  for (const auto& [row, column] : border) inner.push_back(row * (cellsAcross + 1) + column);
  for (int ring = 1; ring <= rings; ++ring) {
    const double size = std::ldexp(halfOfGrid, ring);
    const auto first = static_cast<std::uint32_t>(mesh.positionsMm.size());
    for (const auto& [row, column] : border)
      mesh.positionsMm.push_back(
          plane.at(size * (2.0 * column / cellsAcross - 1), size * (2.0 * row / cellsAcross - 1)));
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t next = (i + 1) % count;
      mesh.triangles.push_back({inner[i], inner[next], first + i});
      mesh.triangles.push_back({inner[next], first + next, first + i});
    }
    for (std::uint32_t i = 0; i < count; ++i) inner[i] = first + i;
  }
}

}  // namespace

Object groundUnder(const Scene& scene, const Ground& ground) {
  const Bounds bounds = boundsOf(scene);
  const Vec3 middle = middleOf(bounds);
  const Plane plane{middle[0], middle[2], ground.heightMm.value_or(bounds.minMm[1]),
                    diagonalMm(scene)};
  Object object;
  object.name = "ground";
  addGrid(plane, object.mesh);
  addRings(plane, object.mesh);
  object.mesh.normals.assign(object.mesh.positionsMm.size(), {0, 1, 0});
  object.opaque = mattMaterial(ground.color);
  object.isGround = true;
  return object;
}

const Object* groundOf(const Scene& scene) {
  const auto found = std::find_if(scene.objects.begin(), scene.objects.end(),
                                  [](const Object& object) { return object.isGround; });
  return found == scene.objects.end() ? nullptr : &*found;
}

void removeGround(Scene& scene) {
  std::erase_if(scene.objects, [](const Object& object) { return object.isGround; });
}

}  // namespace opaline
