#include <gtest/gtest.h>

#include "input.h"
#include "loading.h"
#include "opaline/mesh.h"
#include "scene/repair/orientation.h"
#include "scene/repair/repair.h"
#include "scene/repair/topology.h"
#include "scene/shapes.h"

// Any mesh, with normals and tags or without.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace opaline;
  fuzz::Input input(data, size);
  const std::uint32_t extras = input.below(4);
  const awkward::Shape shape = fuzz::meshFrom(input);
  scene::RawMesh mesh;
  mesh.positions = shape.positions;
  mesh.triangles = shape.triangles;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if ((extras & 1U) != 0) mesh.normals.push_back({input.finite(), input.finite(), 1});
    if ((extras & 2U) != 0) mesh.tags.push_back(v % 3);
  }
  scene::RawMesh turned = mesh;
  scene::orientOutward(turned, scene::sewn(turned.positions, turned.triangles));
  fuzz::expectReadOrRefused([&] {
    scene::repairMesh(mesh, "fuzzed");
    EXPECT_EQ(test::badEdges(mesh.triangles), 0U);
    EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
    for (const Vec3& n : mesh.normals) EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1, 1e-4);
    EXPECT_GE(factsOf(mesh.positions, mesh.triangles).components, 1U);
  });
  return 0;
}
