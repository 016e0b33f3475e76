#include "scene/changes.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "opaline/error.h"
#include "opaline/sequence.h"
#include "scene/gltf/builder.h"
#include "scene/gltf/gltf_fixture.h"
#include "scene/shapes.h"

// What clips change besides nodes: lights, cameras and materials.

namespace opaline {
namespace {

using testing::HasSubstr;

using test::GltfBuilder;

class GltfChanges : public testing::Test {
 protected:
  GltfChanges() {
    const int position = b.vectors({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
    const int index = b.add(test::tetrahedronFaces, "SCALAR", 1);
    b.meshes = fmt::format(
        R"({{"primitives":[{{"attributes":{{"POSITION":{}}},"indices":{},"material":0}}]}})",
        position, index);
    b.nodes = R"({"mesh":0,"name":"tetra"},{"extensions":{"KHR_lights_punctual":{"light":0}}},)"
              R"({"camera":0,"translation":[0,0,3]})";
    times = b.scalars({0, 2});
  }
  void animatePointer(const std::string& pointer, int values,
                      const char* interpolation = "LINEAR") {
    b.animate("go", {GltfBuilder::sampler(times, values, interpolation)},
              {fmt::format(R"("path":"pointer","extensions":{{"KHR_animation_pointer":)"
                           R"({{"pointer":"{}"}}}})",
                           pointer)});
  }
  Scene load(const LoadOptions& options = {}) {
    b.more = R"(,"extensionsUsed":["KHR_animation_pointer","KHR_lights_punctual"],"materials":[)" +
             material + R"(],"cameras":[)" + camera +
             R"(],"extensions":{"KHR_lights_punctual":{"lights":[)" + light + "]}}";
    test::writeBytes(folder / "a.glb", b.file());
    return loadScene(folder / "a.glb", options);
  }
  static Lighting lightingAt(const Scene& scene, double seconds) {
    Lighting lighting = scene.lighting;
    scene::takeLightsAt(scene, {seconds, 0}, lighting);
    return lighting;
  }
  static Camera cameraAt(const Scene& scene, double seconds) {
    Camera camera = scene.camera;
    scene::takeCameraAt(scene, {seconds, 0}, camera);
    return camera;
  }
  static OpaqueMaterial materialAt(const Scene& scene, double seconds) {
    OpaqueMaterial material = *scene.objects[0].opaque;
    scene::takeAt(scene.changes.at(0).surfaces.at(0), seconds, material);
    return material;
  }

  GltfBuilder b;
  std::string material = R"({"pbrMetallicRoughness":{"metallicFactor":0}})";
  std::string camera = R"({"type":"perspective","perspective":{"yfov":0.5,"znear":0.1}})";
  std::string light = R"({"type":"spot","intensity":2,"spot":{}})";
  int times = 0;
  test::TemporaryFolder folder;
};

// A morph has a clip of its own, and a row of meshes none.
TEST_F(GltfChanges, DoNotGoWithMeshesThatReplaceEachOther) {
  b.animate("go", {GltfBuilder::sampler(times, b.vectors({0, 0, 0, 1, 0, 0}))},
            {R"("node":1,"path":"translation")"});
  const auto errorOf = [](const auto& act) {
    try {
      act();
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  LoadOptions options;
  options.morphTo = folder / "a.glb";
  EXPECT_THAT(errorOf([&] { load(options); }),
              HasSubstr("a morph to another mesh needs a model without animation"));
  EXPECT_THAT(errorOf([&] { MeshSequence(folder / "%d.glb"); }), HasSubstr("no file"));
  test::writeBytes(folder / "1.glb", b.file());
  EXPECT_THAT(errorOf([&] { MeshSequence(folder / "%d.glb"); }),
              HasSubstr("a sequence of meshes needs a model without animation"));
}

TEST_F(GltfChanges, LightsFollowTheirNodes) {
  const float half = std::sqrt(0.5F);
  b.animate("go",
            {GltfBuilder::sampler(times, b.vectors({0, 0, 0, 2, 0, 0})),
             GltfBuilder::sampler(times, b.quaternions({0, 0, 0, 1, half, 0, 0, half}))},
            {R"("node":1,"path":"translation")", R"("node":1,"path":"rotation")"});
  const Scene scene = load();
  ASSERT_EQ(scene.changes.size(), 1U);
  const SpotLight spot = lightingAt(scene, 0.5).spots.at(0);
  EXPECT_NEAR(spot.positionMm[0], 500, 1e-2);
  // A quarter of a quarter turn about x takes -z towards +y.
  const double angle = std::numbers::pi / 8;
  EXPECT_NEAR(spot.direction[1], std::sin(angle), 1e-4);
  EXPECT_NEAR(spot.direction[2], -std::cos(angle), 1e-4);
  EXPECT_EQ(spot.intensity, scene.lighting.spots[0].intensity);
  // Times continue from the beginning. Without a clip, lights stand as in the file.
  EXPECT_EQ(lightingAt(scene, 2.5).spots, lightingAt(scene, 0.5).spots);
  Lighting none = scene.lighting;
  scene::takeLightsAt(scene, {0.5, -1}, none);
  EXPECT_EQ(none.spots, scene.lighting.spots);
}

TEST_F(GltfChanges, PowerAndConesOfLights) {
  animatePointer("/extensions/KHR_lights_punctual/lights/0/intensity", b.scalars({2, 6}));
  const Scene intensity = load();
  EXPECT_NEAR(lightingAt(intensity, 1).spots.at(0).intensity[0], 4e6, 1);
}

TEST_F(GltfChanges, StepsHoldUntilTheyEnd) {
  animatePointer("/extensions/KHR_lights_punctual/lights/0/spot/outerConeAngle",
                 b.scalars({0.5F, 1}), "STEP");
  const Scene scene = load();
  const double degree = 180 / std::numbers::pi;
  EXPECT_NEAR(lightingAt(scene, 1.999).spots.at(0).outerDegrees, 0.5 * degree, 1e-4);
  EXPECT_NEAR(lightingAt(scene, 2).spots.at(0).outerDegrees, degree, 1e-4);
}

TEST_F(GltfChanges, CamerasTurnAndZoom) {
  b.animate("go",
            {GltfBuilder::sampler(times, b.vectors({0, 0, 3, 1, 0, 3})),
             GltfBuilder::sampler(times, b.scalars({0.5F, 0.25F}))},
            {R"("node":2,"path":"translation")",
             R"("path":"pointer","extensions":{"KHR_animation_pointer":{"pointer":)"
             R"("/cameras/0/perspective/yfov"}})"});
  const Scene scene = load();
  const Camera camera = cameraAt(scene, 1);
  EXPECT_NEAR(camera.positionMm[0], 500, 1e-2);
  EXPECT_NEAR(camera.targetMm[0], 500, 1e-2);
  EXPECT_NEAR(camera.targetMm[2], scene.camera.targetMm[2], 1e-2);
  EXPECT_NEAR(camera.verticalFovDegrees, 0.375 * 180 / std::numbers::pi, 1e-4);
}

TEST_F(GltfChanges, OrthographicCamerasZoom) {
  camera = R"({"type":"orthographic","orthographic":{"xmag":1,"ymag":1,"znear":0.1,"zfar":9}})";
  animatePointer("/cameras/0/orthographic/ymag", b.scalars({1, 2}));
  EXPECT_NEAR(cameraAt(load(), 1).orthographicHeightMm.value_or(0), 3000, 1e-2);
}

TEST_F(GltfChanges, NumbersOfSurfaces) {
  b.animate("go",
            {GltfBuilder::sampler(times, b.add<float>({1, 0, 0, 1, 0, 1, 0, 0.5F}, "VEC4", 4)),
             GltfBuilder::sampler(times, b.scalars({1, 0.5F}))},
            {R"("path":"pointer","extensions":{"KHR_animation_pointer":{"pointer":)"
             R"("/materials/0/pbrMetallicRoughness/baseColorFactor"}})",
             R"("path":"pointer","extensions":{"KHR_animation_pointer":{"pointer":)"
             R"("/materials/0/pbrMetallicRoughness/roughnessFactor"}})"});
  const Scene scene = load();
  const OpaqueMaterial half = materialAt(scene, 1);
  for (std::size_t c = 0; c < 2; ++c) EXPECT_NEAR(half.baseColor[c], 0.5, 1e-6);
  EXPECT_NEAR(half.alpha, 0.75, 1e-6);
  EXPECT_NEAR(half.roughness, 0.75, 1e-6);
  EXPECT_EQ(half.metallic, 0);
}

// KHR_materials_volume: σ_t = -ln(color) / distance.
TEST_F(GltfChanges, DistancesOfVolumes) {
  material = R"({"name":"jelly","extensions":{"KHR_materials_volume":{"thicknessFactor":1,)"
             R"("attenuationDistance":0.001,"attenuationColor":[0.5,0.5,0.5]},)"
             R"("KHR_materials_volume_scatter":{"multiscatterColorFactor":[0.8,0.8,0.8]}}})";
  animatePointer("/materials/0/extensions/KHR_materials_volume/attenuationDistance",
                 b.scalars({0.001F, 0.003F}));
  const Scene scene = load();
  for (const double seconds : {0.0, 0.37, 1.0, 2.0}) {
    const Medium medium = scene::mediumAt(scene, 0, {seconds, 0});
    const double distanceMm = 1 + seconds;
    EXPECT_NEAR(medium.sigmaSPrimePerMm[1] + medium.sigmaAPerMm[1], std::log(2) / distanceMm,
                1e-4 / distanceMm)
        << seconds;
  }
  EXPECT_EQ(&scene::finestMedium(scene, 0), &scene.objects[0].medium);
}

TEST_F(GltfChanges, PointersToNodesAreTheirTracks) {
  animatePointer("/nodes/0/translation", b.vectors({0, 0, 0, 1, 0, 0}));
  const Scene scene = load();
  ASSERT_EQ(scene.clips.at(0).tracks.size(), 1U);
  EXPECT_EQ(scene.clips[0].tracks[0].target, TrackTarget::Translation);
  EXPECT_TRUE(scene.objects[0].rig);
}

TEST_F(GltfChanges, WhatCannotBeAnimatedIsNamed) {
  for (const std::string pointer :
       {"/materials/0/doubleSided", "/materials/7/alphaCutoff", "/nodes/0/extensions/X/visible",
        "/materials/0/extensions/KHR_materials_volume/attenuationDistance"}) {
    const GltfBuilder before = b;
    animatePointer("/extensions/KHR_lights_punctual/lights/0/intensity", b.scalars({1, 2}));
    animatePointer(pointer, b.scalars({1, 2}));
    const Scene scene = load();
    ASSERT_EQ(scene.notShown.size(), 1U) << pointer;
    EXPECT_EQ(scene.notShown[0].what, "animated properties");
    b = before;
  }
  animatePointer("/materials/0/emissiveFactor", b.scalars({1, 2}));
  EXPECT_THAT(test::messageOf([&] { load(); }), HasSubstr("a.glb"));
}

TEST_F(GltfChanges, FollowTheSizeOfTheirScene) {
  animatePointer("/extensions/KHR_lights_punctual/lights/0/intensity", b.scalars({2, 6}));
  LoadOptions options;
  options.diagonalMm = diagonalMm(load()) / 10;
  const Scene scene = load(options);
  EXPECT_NEAR(lightingAt(scene, 1).spots.at(0).intensity[0], 4e4, 1);
  Scene other = scene;
  stopLights(other);
  EXPECT_EQ(lightingAt(other, 1).spots, scene.lighting.spots);
}

}  // namespace
}  // namespace opaline
