#include "scene/repair/topology.h"

#include <gtest/gtest.h>

#include <vector>

#include "opaline/error.h"
#include "opaline/mesh.h"
#include "scene/shapes.h"

namespace opaline::scene {
namespace {

using test::cube;

TEST(Topology, CubeIsClosed) {
  const RawMesh mesh = cube();
  const MeshFacts facts = factsOf(mesh.positions, mesh.triangles);
  EXPECT_TRUE(facts.closed);
  EXPECT_EQ(facts.boundaryLoops, 0U);
  EXPECT_EQ(facts.components, 1U);
}

TEST(Topology, SoupOfTrianglesIsSewn) {
  const RawMesh mesh = test::soup(cube());
  const MeshFacts facts = factsOf(mesh.positions, mesh.triangles);
  EXPECT_TRUE(facts.closed);
  EXPECT_EQ(facts.components, 1U);
}

TEST(Topology, OpenBoxHasOneLoopAndTubeTwo) {
  RawMesh box = cube();
  box.triangles.erase(box.triangles.begin(), box.triangles.begin() + 2);
  MeshFacts facts = factsOf(box.positions, box.triangles);
  EXPECT_FALSE(facts.closed);
  EXPECT_EQ(facts.boundaryLoops, 1U);
  box.triangles.erase(box.triangles.begin(), box.triangles.begin() + 2);  // the opposite side
  facts = factsOf(box.positions, box.triangles);
  EXPECT_EQ(facts.boundaryLoops, 2U);
  EXPECT_EQ(facts.components, 1U);
}

TEST(Topology, LoopsThatTouchInAPointAreTwo) {
  RawMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 4}};
  const MeshFacts facts = factsOf(mesh.positions, mesh.triangles);
  EXPECT_EQ(facts.boundaryLoops, 2U);
  EXPECT_EQ(facts.components, 1U);
}

TEST(Topology, BodiesThatShareAVertexAreOneComponentAndThoseWithCopiesTwo) {
  RawMesh apart = cube();
  test::append(apart, cube({1, 1, 1}));
  EXPECT_EQ(factsOf(apart.positions, apart.triangles).components, 2U);
  RawMesh joined = apart;
  for (Triangle& t : joined.triangles) {
    for (std::uint32_t& v : t) v = v == 8 ? 7 : v;  // (1,1,1) of both
  }
  EXPECT_EQ(factsOf(joined.positions, joined.triangles).components, 1U);
  EXPECT_TRUE(factsOf(joined.positions, joined.triangles).closed);
}

TEST(Topology, LargeHolesLeaveNoInside) {
  RawMesh box = cube();
  EXPECT_EQ(factsOf(box.positions, box.triangles).trianglesWithoutInside, 0U);
  box.triangles.pop_back();
  test::append(box, cube({3, 0, 0}));
  EXPECT_EQ(factsOf(box.positions, box.triangles).trianglesWithoutInside, 11U);
}

TEST(Topology, OfNothingIsOpenAndOfWhatIsNotThereRefused) {
  EXPECT_FALSE(factsOf({}, {}).closed);
  const std::vector<Triangle> triangles{{0, 1, 2}};
  EXPECT_THROW(factsOf({}, triangles), UsageError);
}

}  // namespace
}  // namespace opaline::scene
