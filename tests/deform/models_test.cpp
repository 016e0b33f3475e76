#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "deform/deformed_vertices.h"
#include "opaline/scene.h"
#include "shared_files.h"

namespace opaline::deform {
namespace {

using scene::Double3;

constexpr const char* missing =
    "the shared models are not here; set OPALINE_MODELS to their folder";

class AnimatedModels : public testing::TestWithParam<const char*> {};

/// Both must agree: the loader bakes the file's static pose by its own arithmetic, while rigs start
/// from the file's vertices.
TEST_P(AnimatedModels, RestPoseIsTheMesh) {
  const auto folder = test::modelsFolder();
  if (!folder) GTEST_SKIP() << missing;
  const Scene scene = loadScene(*folder / "gltf" / GetParam());
  const double tolerance = 2e-6 * double{diagonalMm(scene)};
  ASSERT_FALSE(scene.clips.empty());
  for (std::size_t o = 0; o < scene.objects.size(); ++o) {
    const Object& object = scene.objects[o];
    ASSERT_TRUE(object.rig);
    const DeformedVertices mesh = deformedVertices(scene, o, -1, 0);
    ASSERT_EQ(mesh.positionsMm.size(), object.mesh.positionsMm.size());
    for (std::size_t v = 0; v < mesh.positionsMm.size(); ++v) {
      const Double3 rest = scene::toDouble(object.mesh.positionsMm[v]);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        ASSERT_NEAR(mesh.positionsMm[v][axis], rest[axis], tolerance) << "vertex " << v;
      }
      ASSERT_GT(scene::dot(mesh.normals[v], scene::toDouble(object.mesh.normals[v])), 0.999)
          << "vertex " << v;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, AnimatedModels,
                         testing::Values("AnimatedMorphCube.glb", "AnimatedMorphSphere.glb",
                                         "BunnyEgg.glb", "CesiumMan.glb", "Fox.glb",
                                         "MorphStressTest.gltf", "RiggedFigure.glb",
                                         "RiggedSimple.glb", "SimpleMorph.gltf", "SimpleSkin.gltf",
                                         "greenman.glb"),
                         [](const auto& of) {
                           std::string name(of.param);
                           return name.substr(0, name.find('.'));
                         });

struct Posed {
  const char* file;
  int clip;
  double seconds;
  Double3 lowMm;
  Double3 highMm;
};

/// Boxes around posed vertices, from a separate program that follows the text of glTF 2.0.
const std::vector<Posed> posed{
    {"AnimatedMorphCube.glb", 0, 1.26, {-1000, -1000, -1000}, {1000, 999.9999, -672.8865}},
    {"AnimatedMorphCube.glb", 0, 3.234, {-1000, -1000, -1000}, {1000, 999.9998, 954.5464}},
    {"AnimatedMorphSphere.glb", 0, 2.16, {-1614.726, -1000, -1065.224}, {1614.726, 1000, 1039.399}},
    {"AnimatedMorphSphere.glb", 0, 5.544, {-1850.208, -1000, -2381.618}, {1850.208, 1000, 1908.31}},
    {"BunnyEgg.glb", 0, 1.5, {-82.43112, 33.01725, -38.26515}, {30.57411, 171.3551, 57.17442}},
    {"CesiumMan.glb", 0, 0.6, {-455.0676, 35.27782, -195.8353}, {420.2022, 1487.742, 237.643}},
    {"CesiumMan.glb", 0, 1.54, {-328.1605, 20.0185, -200.3587}, {347.767, 1504.725, 283.9147}},
    {"Fox.glb", 0, 1.025, {-11597.16, -130.863, -83214.29}, {22600.45, 76558.04, 63022.07}},
    {"Fox.glb", 0, 2.631, {-20174.96, -130.7433, -83825.12}, {12592.71, 79242.78, 68750.44}},
    {"Fox.glb", 1, 0.212, {-11920.91, -309.8906, -93747.3}, {13261.26, 75611.47, 69981.1}},
    {"Fox.glb", 1, 0.545, {-12375.81, -17.4478, -96736.33}, {12802.57, 71961.96, 70175.41}},
    {"Fox.glb", 2, 0.347, {-13059.53, 2063.12, -91076.85}, {13700.68, 71725.6, 74665.35}},
    {"Fox.glb", 2, 0.892, {-16828.6, -2063.254, -97349.78}, {16610.34, 67361.52, 66101.59}},
    {"MorphStressTest.gltf", 0, 2.8, {-2000, -100, -500}, {2000, 1447.496, 500}},
    {"MorphStressTest.gltf", 0, 7.187, {-2000, -100, -500}, {2000, 727.6422, 500}},
    {"MorphStressTest.gltf", 1, 1.9, {-2000, -100, -500}, {2000, 1500, 500}},
    {"MorphStressTest.gltf", 1, 4.877, {-2000, -100, -500}, {2000, 1500, 500}},
    {"MorphStressTest.gltf", 2, 0.588, {-2000, -100, -500}, {2000, 1462.671, 500}},
    {"MorphStressTest.gltf", 2, 1.508, {-2000, -100, -500}, {2000, 1477.716, 500}},
    {"RiggedFigure.glb",
     0,
     0.375,
     {-387.8754, -4.255781e-05, -118.8444},
     {376.3333, 1471.702, 226.6239}},
    {"RiggedFigure.glb",
     0,
     0.963,
     {-536.2004, -4.255781e-05, -127.4466},
     {531.3541, 1458.787, 205.0942}},
    {"RiggedSimple.glb", 0, 0.625, {-1000, -4575.077, -1990.044}, {1000, 4462.283, 999.9998}},
    {"RiggedSimple.glb", 0, 1.604, {-1000, -4575.077, -1678.683}, {1000, 4532.517, 999.9998}},
    {"SimpleMorph.gltf", 0, 1.2, {0, 0, 0}, {1300, 1700, 0}},
    {"SimpleMorph.gltf", 0, 3.08, {-420, 0, 0}, {1000, 1420, 0}},
    {"SimpleSkin.gltf", 0, 1.65, {-1089.055, 0, 0}, {525.7133, 1719.504, 0}},
    {"SimpleSkin.gltf", 0, 4.235, {-500, 0, 0}, {1000, 1500, 0}},
    {"greenman.glb", 0, 0.05, {-1359.979, -41.57997, -722.582}, {1359.979, 1990.126, 726.2169}},
    {"greenman.glb", 0, 0.128, {-1359.979, -41.57997, -722.582}, {1359.979, 1990.126, 726.2169}},
    {"greenman.glb", 1, 0.75, {-1262.746, -43.1604, -700.2156}, {1225.819, 2009.108, 756.2484}},
    {"greenman.glb", 1, 1.925, {-1194.666, -47.37769, -702.0633}, {1278.858, 2008.017, 753.9519}},
    {"greenman.glb", 2, 0.375, {-1256.274, -78.44426, -606.4494}, {1313.427, 2154.914, 972.1369}},
    {"greenman.glb", 2, 0.963, {-1250.295, -55.53715, -616.6492}, {1308.86, 2169.824, 972.1369}},
    {"greenman.glb", 3, 0.25, {-1345.24, -49.77271, -742.5268}, {1370.164, 2006.351, 687.8664}},
    {"greenman.glb", 3, 0.642, {-1318.577, -48.51327, -731.4015}, {1415.458, 2003.959, 727.2168}},
};

class PosedModels : public testing::TestWithParam<Posed> {};

TEST_P(PosedModels, FillTheBoxOfTheSpecification) {
  const auto folder = test::modelsFolder();
  if (!folder) GTEST_SKIP() << missing;
  const Posed& of = GetParam();
  const Scene scene = loadScene(*folder / "gltf" / of.file);
  Double3 low{INFINITY, INFINITY, INFINITY};
  Double3 high{-INFINITY, -INFINITY, -INFINITY};
  for (std::size_t o = 0; o < scene.objects.size(); ++o) {
    for (const Double3& p : deformedVertices(scene, o, of.clip, of.seconds).positionsMm) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], p[axis]);
        high[axis] = std::max(high[axis], p[axis]);
      }
    }
  }
  const double tolerance = 1e-5 * double{diagonalMm(scene)};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(low[axis], of.lowMm[axis], tolerance);
    EXPECT_NEAR(high[axis], of.highMm[axis], tolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(All, PosedModels, testing::ValuesIn(posed), [](const auto& of) {
  std::string name(of.param.file);
  return name.substr(0, name.find('.')) + "_" + std::to_string(of.index);
});

TEST(SharedModels, HaveTheClipsAndJointsOfTheirFiles) {
  const auto folder = test::modelsFolder();
  if (!folder) GTEST_SKIP() << missing;
  const Scene fox = loadScene(*folder / "gltf/Fox.glb");
  ASSERT_EQ(fox.clips.size(), 3U);
  EXPECT_EQ(fox.clips[0].name, "Survey");
  EXPECT_EQ(fox.clips[1].name, "Walk");
  EXPECT_EQ(fox.clips[2].name, "Run");
  EXPECT_NEAR(fox.clips[0].seconds, 3.416667, 1e-5);
  EXPECT_NEAR(fox.clips[1].seconds, 0.708333, 1e-5);
  EXPECT_NEAR(fox.clips[2].seconds, 1.158333, 1e-5);
  EXPECT_EQ(fox.objects[0].rig->joints.size(), 24U);
  EXPECT_TRUE(fox.objects[0].mesh.facetted);
  const Scene man = loadScene(*folder / "gltf/CesiumMan.glb");
  EXPECT_EQ(man.objects[0].rig->joints.size(), 19U);
  EXPECT_FALSE(man.objects[0].mesh.facetted);
  const Scene stress = loadScene(*folder / "gltf/MorphStressTest.gltf");
  ASSERT_EQ(stress.clips.size(), 3U);
  EXPECT_EQ(stress.clips[1].name, "Pulse");
  EXPECT_EQ(stress.objects[0].rig->targets.size(), 8U);
  EXPECT_TRUE(loadScene(*folder / "gltf/TranslucentTrio.glb").clips.empty());
  EXPECT_FALSE(loadScene(*folder / "gltf/SimpleSparseAccessor.gltf").objects[0].rig);
}

/// The largest heights in bunny_egg_a.ply and bunny_egg_b.ply.
TEST(SharedModels, BunnyBecomesTheEgg) {
  const auto folder = test::modelsFolder();
  if (!folder) GTEST_SKIP() << missing;
  Scene scene = loadScene(*folder / "gltf/BunnyEgg.glb");
  ASSERT_EQ(scene.objects[0].rig->targets.size(), 1U);
  const auto heightAt = [&](float weight) {
    scene.nodes[scene.objects[0].rig->node].morphWeights = {weight};
    double high = 0;
    for (const Double3& p : deformedVertices(scene, 0, -1, 0).positionsMm)
      high = std::max(high, p[1]);
    return high;
  };
  EXPECT_NEAR(heightAt(0), 187.3210, 1e-3);
  EXPECT_NEAR(heightAt(1), 167.1542, 1e-3);
}

TEST(SharedModels, OnePlyMorphsToTheOther) {
  const auto folder = test::modelsFolder();
  if (!folder) GTEST_SKIP() << missing;
  LoadOptions options;
  options.morphTo = *folder / "bunny_egg_b.ply";
  const Scene scene = loadScene(*folder / "bunny_egg_a.ply", options);
  const double mmPerUnit{scene.objects[0].rig->toScene.columns[1][1]};
  const auto heightAt = [&](double seconds) {
    double high = 0;
    for (const Double3& p : deformedVertices(scene, 0, 0, seconds).positionsMm) {
      high = std::max(high, p[1]);
    }
    return high / mmPerUnit;
  };
  EXPECT_NEAR(heightAt(0), 0.187321, 1e-6);
  EXPECT_NEAR(heightAt(2), 0.1671542, 1e-6);
  EXPECT_NEAR(heightAt(4), 0.187321, 1e-6);
  EXPECT_NEAR(heightAt(6), 0.1671542, 1e-6);
}

TEST(SharedModels, AManOfOneAndAHalfMetresWalksUpright) {
  const auto folder = test::modelsFolder();
  if (!folder) GTEST_SKIP() << missing;
  const Scene scene = loadScene(*folder / "gltf/CesiumMan.glb");
  for (double seconds = 0; seconds < 2; seconds += 0.125) {
    double low = INFINITY;
    double high = 0;
    for (const Double3& p : deformedVertices(scene, 0, 0, seconds).positionsMm) {
      low = std::min(low, p[1]);
      high = std::max(high, p[1]);
    }
    EXPECT_NEAR(high - low, 1490, 60) << seconds;
  }
}

}  // namespace
}  // namespace opaline::deform
