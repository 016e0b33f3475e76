#include "scene/shapes.h"

#include <algorithm>
#include <map>

namespace opaline::test {

std::size_t badEdges(const std::vector<Triangle>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (const Triangle& t : triangles) {
    for (std::size_t c = 0; c < 3; ++c) ++sides[{t[c], t[(c + 1) % 3]}];
  }
  std::size_t bad = 0;
  for (const auto& [side, count] : sides) bad += count > 1 ? 1U : 0U;
  return bad;
}

void expectSound(const Scene& scene) {
  ASSERT_FALSE(scene.objects.empty());
  for (const Object& object : scene.objects) {
    const Mesh& mesh = object.mesh;
    ASSERT_FALSE(mesh.triangles.empty());
    ASSERT_EQ(mesh.positionsMm.size(), mesh.normals.size());
    for (const Triangle& t : mesh.triangles) {
      for (const std::uint32_t v : t) ASSERT_LT(v, mesh.positionsMm.size());
    }
    for (std::size_t v = 0; v < mesh.normals.size(); ++v) {
      const Vec3& p = mesh.positionsMm[v];
      const Vec3& n = mesh.normals[v];
      ASSERT_TRUE(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]));
      ASSERT_NEAR(std::hypot(n[0], n[1], n[2]), 1.0F, 1e-4F);
    }
    ASSERT_EQ(badEdges(mesh.triangles), 0U);
  }
  ASSERT_TRUE(std::isfinite(diagonalMm(scene)));
}

}  // namespace opaline::test
