#include "scene/pose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "deform/vectors.h"

namespace opaline::scene {
namespace {

using deform::expectVector;
using deform::root;

Scene oneNode(Track track, float seconds) {
  Scene scene;
  scene.nodes.push_back({"node"});
  scene.clips.push_back({"clip", seconds, {std::move(track)}});
  return scene;
}

Pose poseOf(const Scene& scene, double seconds, int clip = 0) {
  Pose pose = makePose(scene);
  poseAt(scene, clip, seconds, pose);
  return pose;
}

double translationX(const Scene& scene, double seconds) {
  return poseOf(scene, seconds).world[0].column[3][0];
}

Track translation(Interpolation interpolation, std::vector<float> values) {
  return {0, TrackTarget::Translation, interpolation, {1, 2, 4}, std::move(values)};
}

TEST(Pose, StepsHoldTheLastKey) {
  const Scene scene = oneNode(translation(Interpolation::Step, {10, 0, 0, 20, 0, 0, 40, 0, 0}), 4);
  EXPECT_EQ(translationX(scene, 0.5), 10);
  EXPECT_EQ(translationX(scene, 1), 10);
  EXPECT_EQ(translationX(scene, 1.999), 10);
  EXPECT_EQ(translationX(scene, 2), 20);
  EXPECT_EQ(translationX(scene, 3.999), 20);
  EXPECT_EQ(translationX(scene, 4), 40);
}

TEST(Pose, LinesClampAtBothEnds) {
  const Scene scene =
      oneNode(translation(Interpolation::Linear, {10, 0, 0, 20, 0, 0, 40, 0, 0}), 4);
  EXPECT_EQ(translationX(scene, -3), 10);
  EXPECT_EQ(translationX(scene, 0), 10);
  EXPECT_NEAR(translationX(scene, 1.25), 12.5, 1e-12);
  EXPECT_NEAR(translationX(scene, 3), 30, 1e-12);
  EXPECT_EQ(translationX(scene, 4), 40);
}

TEST(Pose, TimeBeyondTheEndIsTakenModuloTheLength) {
  Scene scene = oneNode(translation(Interpolation::Linear, {10, 0, 0, 20, 0, 0, 40, 0, 0}), 4);
  EXPECT_NEAR(translationX(scene, 7), 30, 1e-12);
  EXPECT_EQ(translationX(scene, 8), 10);  // 8 mod 4 is 0, before the first key
  EXPECT_NEAR(translationX(scene, 4003), 30, 1e-12);
  // Another track makes the clip longer; until then the last key's value holds.
  scene.clips[0].seconds = 10;
  EXPECT_EQ(translationX(scene, 9), 40);
  EXPECT_EQ(translationX(scene, 10), 40);
  EXPECT_NEAR(translationX(scene, 13), 30, 1e-12);
}

TEST(Pose, AClipWithoutLengthStands) {
  Scene scene = oneNode({0, TrackTarget::Translation, Interpolation::Linear, {0}, {7, 0, 0}}, 0);
  for (const double seconds : {0.0, 0.5, 100.0}) EXPECT_EQ(translationX(scene, seconds), 7);
  EXPECT_EQ(translationX(scene, std::nan("")), 7);
  EXPECT_EQ(translationX(scene, INFINITY), 7);
}

/// With exact tangents the Hermite curve reproduces the cubic x = t³ − 2t² + 3t + 5.
TEST(Pose, CubicSplinesReproduceACubic) {
  const auto x = [](double t) { return t * t * t - 2 * t * t + 3 * t + 5; };
  const auto slope = [](double t) { return 3 * t * t - 4 * t + 3; };
  Track track{0, TrackTarget::Translation, Interpolation::CubicSpline, {0.5F, 2, 4.5F}, {}};
  for (const float t : track.seconds) {
    const auto in = static_cast<float>(slope(double{t}));
    track.values.insert(track.values.end(),
                        {in, 0, 0, static_cast<float>(x(double{t})), 0, 0, in, 0, 0});
  }
  const Scene scene = oneNode(track, 4.5F);
  for (double t = 0.5; t <= 4.5; t += 0.125) EXPECT_NEAR(translationX(scene, t), x(t), 1e-5) << t;
  EXPECT_NEAR(translationX(scene, 0), x(0.5), 1e-5);
}

/// In- and out-tangents of a key differ. The in-tangent of the second key and the out-tangent of
/// the first count. With values 0, tangents 1 and length 2, the middle is (t³−2t²+t)·2·1 = ¼ from
/// the first and (t³−t²)·2·1 = −¼ from the second.
TEST(Pose, CubicSplinesTakeTheTangentsThatFaceTheInterval) {
  const auto middle = [](float outOfFirst, float intoSecond) {
    const Track track{0,
                      TrackTarget::Translation,
                      Interpolation::CubicSpline,
                      {0, 2},
                      {99, 0, 0, 0, 0, 0, outOfFirst, 0, 0, intoSecond, 0, 0, 0, 0, 0, 77, 0, 0}};
    return translationX(oneNode(track, 2), 1);
  };
  EXPECT_NEAR(middle(1, 0), 0.25, 1e-12);
  EXPECT_NEAR(middle(0, 1), -0.25, 1e-12);
}

Scene turning(Interpolation interpolation, std::vector<float> values) {
  return oneNode({0, TrackTarget::Rotation, interpolation, {0, 1}, std::move(values)}, 1);
}

/// The direction of the x axis, as an angle about +z.
double angleOfX(const Scene& scene, double seconds) {
  const Double3 x = poseOf(scene, seconds).world[0].column[0];
  EXPECT_NEAR(length(x), 1, 1e-6);
  return std::atan2(x[1], x[0]);
}

TEST(Pose, RotationsTurnAtConstantSpeed) {
  // From no rotation to a quarter turn about z.
  const Scene scene = turning(Interpolation::Linear, {0, 0, 0, 1, 0, 0, root, root});
  for (const double t : {0.0, 0.1, 0.25, 0.5, 0.8, 1.0}) {
    EXPECT_NEAR(angleOfX(scene, t), t * std::numbers::pi / 2, 1e-6);
  }
}

TEST(Pose, RotationsGoTheShorterWayWhateverTheSign) {
  const Scene scene = turning(Interpolation::Linear, {0, 0, 0, 1, 0, 0, -root, -root});
  for (const double t : {0.0, 0.1, 0.25, 0.5, 0.8, 1.0}) {
    EXPECT_NEAR(angleOfX(scene, t), t * std::numbers::pi / 2, 1e-6);
  }
}

TEST(Pose, AlmostEqualRotationsStayFinite) {
  const Scene scene = turning(Interpolation::Linear, {0, 0, 0, 1, 0, 0, 1e-8F, 1});
  EXPECT_NEAR(angleOfX(scene, 0.5), 1e-8, 1e-12);
  const Scene opposite = turning(Interpolation::Linear, {0, 0, 0, 1, 0, 0, 0, -1});
  EXPECT_NEAR(angleOfX(opposite, 0.5), 0, 1e-12);
}

TEST(Pose, RotationsStep) {
  const Scene scene = turning(Interpolation::Step, {0, 0, 0, 1, 0, 0, root, root});
  EXPECT_NEAR(angleOfX(scene, 0.999), 0, 1e-6);
  EXPECT_NEAR(angleOfX(scene, 1), std::numbers::pi / 2, 1e-6);
}

TEST(Pose, CubicRotationsAreNormalised) {
  // With zero tangents the middle is half of both: (0, 0, ½ root, ½ + ½ root), an eighth of a turn.
  const Scene scene =
      turning(Interpolation::CubicSpline, {0, 0, 0, 0, 0, 0, 0,    1,    0, 0, 0, 0,  //
                                           0, 0, 0, 0, 0, 0, root, root, 0, 0, 0, 0});
  EXPECT_NEAR(angleOfX(scene, 0.5), std::numbers::pi / 4, 1e-6);
  // At ¼ the weights are 27/32 and 5/32.
  const double z = 5.0 / 32 * std::sqrt(0.5);
  const double w = 27.0 / 32 + 5.0 / 32 * std::sqrt(0.5);
  EXPECT_NEAR(angleOfX(scene, 0.25), 2 * std::atan2(z, w), 1e-6);
}

TEST(Pose, ScaleAndWeightsAreTracksToo) {
  Scene scene =
      oneNode({0, TrackTarget::Scale, Interpolation::Linear, {0, 1}, {1, 1, 1, 3, 5, 7}}, 1);
  scene.nodes[0].morphWeights = {0.25F, 0.5F};
  scene.clips[0].tracks.push_back(
      {0, TrackTarget::MorphWeights, Interpolation::Linear, {0, 1}, {0, 1, 1, 0.5F}});
  const Pose pose = poseOf(scene, 0.5);
  expectVector(pose.world[0].column[0], {2, 0, 0});
  expectVector(pose.world[0].column[1], {0, 3, 0});
  expectVector(pose.world[0].column[2], {0, 0, 4});
  ASSERT_EQ(pose.weights.size(), 2U);
  EXPECT_FLOAT_EQ(pose.weights[0], 0.5F);
  EXPECT_FLOAT_EQ(pose.weights[1], 0.75F);
  const Pose still = poseOf(scene, 0.5, -1);
  EXPECT_FLOAT_EQ(still.weights[0], 0.25F);
  EXPECT_FLOAT_EQ(still.weights[1], 0.5F);
}

TEST(Pose, CubicWeightsReadTheirOwnTangents) {
  Scene scene = oneNode({0, TrackTarget::MorphWeights, Interpolation::CubicSpline, {0, 1}, {}}, 1);
  scene.nodes[0].morphWeights = {0, 0};
  // Per key: two in-tangents, two values, two out-tangents. The second weight has the out-tangent
  // 8, and 8·(t³−2t²+t) = 1 in the middle.
  scene.clips[0].tracks[0].values = {0, 0, 0, 0, 0, 8, 0, 0, 1, 0, 0, 0};
  const Pose pose = poseOf(scene, 0.5);
  EXPECT_FLOAT_EQ(pose.weights[0], 0.5F);
  EXPECT_FLOAT_EQ(pose.weights[1], 1);
}

TEST(Pose, WhatAClipLeavesOutStaysAsTheFileHasIt) {
  Scene scene = oneNode(translation(Interpolation::Linear, {10, 0, 0, 20, 0, 0, 40, 0, 0}), 4);
  scene.nodes[0].rotation = {0, 0, root, root};
  scene.nodes[0].scale = {2, 3, 4};
  const Pose pose = poseOf(scene, 4);
  expectVector(pose.world[0].column[0], {0, 2, 0});
  expectVector(pose.world[0].column[1], {-3, 0, 0});
  expectVector(pose.world[0].column[3], {40, 0, 0});
  // Earlier poses leave nothing behind.
  Pose again = poseOf(scene, 4);
  poseAt(scene, -1, 0, again);
  expectVector(again.world[0].column[3], {0, 0, 0});
}

TEST(Pose, ChildrenFollowTheirParents) {
  Scene scene;
  scene.nodes.push_back({"root", -1, {1, 0, 0}, {0, 0, root, root}});
  scene.nodes.push_back({"child", 0, {2, 0, 0}});
  Node matrix{"matrix", 1};
  matrix.matrix = Affine{{{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {0, 0, 5}}}};
  scene.nodes.push_back(matrix);
  const Pose pose = makePose(scene);
  expectVector(pose.world[1].column[3], {1, 2, 0});
  expectVector(pose.world[2].column[3], {1, 2, 5});
  expectVector(pose.world[2].column[0], {0, 2, 0});
}

TEST(Pose, JointMatricesEndInTheScene) {
  Scene scene;
  scene.nodes.push_back({"root", -1, {1, 0, 0}});
  scene.nodes.push_back({"joint", 0, {0, 2, 0}});
  Rig rig;
  rig.toScene = Affine{{{{1000, 0, 0}, {0, 1000, 0}, {0, 0, 1000}, {0, 0, 7}}}};
  std::vector<Matrix4> matrices(1);
  rig.node = 1;
  jointMatrices(rig, makePose(scene), matrices);
  expectVector(matrices[0].point({0, 0, 0}), {1000, 2000, 7}, 1e-3);
  rig.joints = {{1, Affine{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, -2, 0}}}}}};
  jointMatrices(rig, makePose(scene), matrices);
  expectVector(matrices[0].point({3, 4, 5}), {3000, 4000, 5007}, 1e-3);
}

TEST(Pose, WeightsThatTheNodeDoesNotGiveAreZero) {
  Scene scene;
  scene.nodes.push_back({"node"});
  scene.nodes[0].morphWeights = {0.5F};
  scene.objects.resize(1);
  scene.objects[0].rig.emplace();
  scene.objects[0].rig->targets.resize(3);
  const Pose pose = makePose(scene);
  const auto weights = morphWeights(*scene.objects[0].rig, pose);
  ASSERT_EQ(weights.size(), 3U);
  EXPECT_EQ(weights[0], 0.5F);
  EXPECT_EQ(weights[1], 0);
  EXPECT_EQ(weights[2], 0);
}

}  // namespace
}  // namespace opaline::scene
