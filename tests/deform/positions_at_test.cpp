#include "opaline/positions.h"

#include <gtest/gtest.h>

#include <cmath>

#include "opaline/error.h"
#include "opaline/mesh.h"

namespace opaline {
namespace {

Mesh triangle() {
  return makeMesh({{0, 0, 0}, {2, 0, 0}, {0, 4, 0}}, {{0, 1, 2}});
}

// A node that moves 3 mm to the right in 2 s carries the first object; the second one does not
// move.
Scene carried() {
  Scene scene;
  scene.objects.resize(2);
  for (Object& object : scene.objects) object.mesh = triangle();
  Rig& rig = scene.objects[0].rig.emplace();
  rig.positions = scene.objects[0].mesh.positionsMm;
  rig.normals = scene.objects[0].mesh.normals;
  scene.nodes.emplace_back();
  Track track{.node = 0, .target = TrackTarget::Translation};
  track.seconds = {0, 2};
  track.values = {0, 0, 0, 3, 0, 0};
  scene.clips.push_back({"right", 2, {track}});
  return scene;
}

TEST(PositionsAt, ClipsCarryWhatIsAtTheirNodes) {
  const auto positions = positionsAt(carried(), {.seconds = 1, .clip = 0});
  ASSERT_EQ(positions.size(), 2U);
  EXPECT_EQ(positions[0][1], (Vec3{3.5F, 0, 0}));
  EXPECT_EQ(positions[1], triangle().positionsMm);
  EXPECT_EQ(positionsAt(carried(), {.seconds = 1, .clip = -1})[0], triangle().positionsMm);
}

// Squash scales the height by 1 - amount about the bottom of the box, and keeps the volume.
TEST(PositionsAt, DeformersMoveEverythingButAGround) {
  Scene scene = carried();
  scene.objects.push_back(groundUnder(scene));
  scene.deformers.push_back({DeformerKind::Squash, 0.75F, 0});
  const auto positions = positionsAt(scene, {.seconds = 0, .clip = 0});
  EXPECT_NEAR(positions[1][2][1] - positions[1][0][1], 1, 1e-5F);
  EXPECT_NEAR(positions[1][1][0] - positions[1][0][0], 4, 1e-5F);
  EXPECT_EQ(positions[2], scene.objects[2].mesh.positionsMm);
}

TEST(PositionsAt, GivenPositionsTakeThePlaceOfRigs) {
  Scene scene = carried();
  const PositionsByObject given{{0, {{0, 0, 1}, {2, 0, 1}, {0, 4, 1}}}};
  EXPECT_EQ(positionsAt(scene, {.seconds = 2, .clip = 0}, given)[0], given.at(0));
  scene.deformers.push_back({DeformerKind::Squash, 0.75F, 0});
  EXPECT_NEAR(positionsAt(scene, {}, given)[0][2][1], 1, 1e-5F) << "deformers still apply";
}

TEST(PositionsAt, RefusesWhatDoesNotFit) {
  const Scene scene = carried();
  EXPECT_THROW(positionsAt(scene, {.clip = 1}), UsageError);
  EXPECT_THROW(positionsAt(scene, {.clip = -2}), UsageError);
  EXPECT_THROW(positionsAt(scene, {}, {{0, {{0, 0, 1}}}}), UsageError);
  EXPECT_THROW(positionsAt(scene, {}, {{2, {}}}), UsageError);
  for (const float bad : {NAN, INFINITY, 2e18F})
    EXPECT_THROW(positionsAt(scene, {}, {{1, {{0, 0, 1}, {0, bad, 0}, {1, 0, 0}}}}), UsageError);
}

}  // namespace
}  // namespace opaline
