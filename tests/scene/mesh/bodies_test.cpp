// Which objects form one body.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "opaline/mesh.h"
#include "opaline/scene.h"

namespace opaline {
namespace {

using testing::ElementsAre;

/// A box over a square from x to x + 1, without its side towards +x or -x.
Mesh openBox(float x, bool opensForwards) {
  const std::vector<Vec3> corners{{x, 0, 0}, {x + 1, 0, 0}, {x + 1, 1, 0}, {x, 1, 0},
                                  {x, 0, 1}, {x + 1, 0, 1}, {x + 1, 1, 1}, {x, 1, 1}};
  std::vector<Triangle> sides{{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7},
                              {0, 1, 5}, {0, 5, 4}, {3, 7, 6}, {3, 6, 2}};
  if (opensForwards)
    sides.insert(sides.end(), {{0, 4, 7}, {0, 7, 3}});
  else
    sides.insert(sides.end(), {{1, 2, 6}, {1, 6, 5}});
  return makeMesh(corners, sides);
}

Scene partsOf(const std::vector<Mesh>& meshes) {
  Scene scene;
  for (const Mesh& mesh : meshes) scene.objects.push_back({.name = "part", .mesh = mesh});
  return scene;
}

TEST(Bodies, PartsWhoseBordersMeetAreOneClosedBody) {
  const Scene scene = partsOf({openBox(0, true), openBox(5, true), openBox(1, false)});
  const std::vector<BodyFacts> bodies = bodiesOf(scene);
  ASSERT_EQ(bodies.size(), 2U);
  EXPECT_THAT(bodies[0].objects, ElementsAre(0U, 2U));
  EXPECT_THAT(bodies[0].trianglesWithoutInside, ElementsAre(0U, 0U));
  EXPECT_TRUE(bodies[0].surface.closed);
  EXPECT_EQ(bodies[0].surface.components, 1U);
  EXPECT_THAT(bodies[1].objects, ElementsAre(1U));
  EXPECT_THAT(bodies[1].trianglesWithoutInside, ElementsAre(10U));
  EXPECT_EQ(bodies[1].surface.boundaryLoops, 1U);
}

TEST(Bodies, WhatIsOpaqueIsNoPartOfAnother) {
  Scene scene = partsOf({openBox(0, true), openBox(1, false)});
  scene.objects[1].opaque = mattMaterial({1, 1, 1});
  EXPECT_EQ(bodiesOf(scene).size(), 2U);
}

TEST(Bodies, PartsThatTouchWithoutBordersStayApart) {
  EXPECT_EQ(bodiesOf(partsOf({openBox(0, true), openBox(0, true)})).size(), 2U);   // copies
  EXPECT_EQ(bodiesOf(partsOf({openBox(0, false), openBox(1, true)})).size(), 2U);  // edges meet
  EXPECT_EQ(bodiesOf(partsOf({openBox(0, true), openBox(2, false)})).size(), 2U);  // a gap
}

}  // namespace
}  // namespace opaline
