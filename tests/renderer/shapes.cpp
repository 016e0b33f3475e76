#include "renderer/shapes.h"

#include <numbers>

#include "icosphere.h"

namespace opaline::test {

Mesh sphere(const Vec3& centreMm, float radiusMm, int levels) {
  const Icosphere ball = icosphere(levels);
  Mesh mesh;
  mesh.triangles = ball.triangles;
  for (const Vector& direction : ball.directions) {
    mesh.normals.push_back(toVec3(direction));
    mesh.positionsMm.push_back(
        toVec3(toVector(centreMm) + static_cast<double>(radiusMm) * direction));
  }
  return mesh;
}

Mesh sheet(const Vec3& centreMm, const Vec3& halfU, const Vec3& halfV, int cells) {
  Mesh mesh;
  const Vec3 normal = toVec3(unit(cross(toVector(halfU), toVector(halfV))));
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) {
      mesh.positionsMm.push_back(toVec3(toVector(centreMm) +
                                        (2.0 * i / cells - 1) * toVector(halfU) +
                                        (2.0 * j / cells - 1) * toVector(halfV)));
      mesh.normals.push_back(normal);
    }
  const auto row = static_cast<std::uint32_t>(cells + 1);
  for (std::uint32_t j = 0; j + 1 < row; ++j)
    for (std::uint32_t i = 0; i + 1 < row; ++i) {
      const std::uint32_t a = j * row + i;
      mesh.triangles.push_back({a, a + 1, a + row + 1});
      mesh.triangles.push_back({a, a + row + 1, a + row});
    }
  return mesh;
}

Mesh box(const Vec3& centreMm, const Vec3& halfMm, int cells) {
  Mesh mesh;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      Vector outward{};
      Vector u{};
      Vector v{};
      outward[axis] = side * static_cast<double>(halfMm[axis]);
      u[(axis + 1) % 3] = static_cast<double>(halfMm[(axis + 1) % 3]);
      v[(axis + 2) % 3] = side * static_cast<double>(halfMm[(axis + 2) % 3]);
      mesh =
          together(mesh, sheet(toVec3(toVector(centreMm) + outward), toVec3(u), toVec3(v), cells));
    }
  return mesh;
}

Mesh together(const Mesh& a, const Mesh& b) {
  Mesh sum = a;
  const auto base = static_cast<std::uint32_t>(a.positionsMm.size());
  sum.positionsMm.insert(sum.positionsMm.end(), b.positionsMm.begin(), b.positionsMm.end());
  sum.normals.insert(sum.normals.end(), b.normals.begin(), b.normals.end());
  for (const Triangle& t : b.triangles)
    sum.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  return sum;
}

std::array<Mesh, 2> halvesOf(const Mesh& mesh, const Vector& direction) {
  std::array<Mesh, 2> halves;
  std::array<std::vector<std::uint32_t>, 2> names;
  for (std::vector<std::uint32_t>& of : names) of.assign(mesh.positionsMm.size(), ~0U);
  for (const Triangle& t : mesh.triangles) {
    Vector middle{};
    for (const std::uint32_t corner : t) middle = middle + toVector(mesh.positionsMm[corner]);
    const std::size_t which = dot(middle, direction) > 0 ? 0 : 1;
    Mesh& half = halves[which];
    Triangle part{};
    for (std::size_t i = 0; i < 3; ++i) {
      std::uint32_t& name = names[which][t[i]];
      if (name == ~0U) {
        name = static_cast<std::uint32_t>(half.positionsMm.size());
        half.positionsMm.push_back(mesh.positionsMm[t[i]]);
        half.normals.push_back(mesh.normals[t[i]]);
      }
      part[i] = name;
    }
    half.triangles.push_back(part);
  }
  return halves;
}

Medium marble() {
  return {"marble", {2.19, 2.62, 3.00}, {.0021, .0041, .0071}, 1.5};
}
Medium skin() {
  return {"skin1", {.74, .88, 1.01}, {.032, .17, .48}, 1.3};
}

Scene sceneOf(const Mesh& mesh, const Medium& medium, const Vec3& cameraMm, float reachMm) {
  Scene scene;
  scene.name = "test";
  scene.objects.push_back({"body", mesh, medium});
  scene.camera.positionMm = cameraMm;
  const double sine = static_cast<double>(reachMm) / length(toVector(cameraMm));
  scene.camera.verticalFovDegrees =
      static_cast<float>(2 * std::asin(sine) * 180 / std::numbers::pi);
  return scene;
}

}  // namespace opaline::test
