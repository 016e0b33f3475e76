// What the renderer refuses, and sizes at the limits of what it accepts.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "awkward_meshes.h"
#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"
#include "shared_files.h"

namespace opaline {
namespace {

using namespace test;

namespace fs = std::filesystem;

using RobustnessTest = RendererTest;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

Scene plainBall() {
  Scene scene = sceneOf(sphere({0, 0, 0}, 5, 3), marble(), {0, 0, 20}, 6);
  scene.lighting.directional = {{{0, 0, 1}, {1, 1, 1}}};
  scene.lighting.ambient = {0.1F, 0.1F, 0.1F};
  return scene;
}

void expectSound(const std::vector<Image>& images, const std::string& what) {
  for (const Image& image : images)
    for (const float value : image.rgba)
      ASSERT_TRUE(std::isfinite(value) && value >= 0) << what << ": " << value;
}

/// Checks the light of the current scene, for every transport and sum.
void expectLightIsSound(const std::string& what) {
  for (const Transport transport : {Transport::Dipole, Transport::Boundary})
    for (const Site site : {Site::Vertex, Site::Fragment}) {
      RenderOptions options = smallOptions();
      options.transport = transport;
      options.width = options.height = 32;
      options.maxClusters = 256;
      options.maxSurfels = 2048;
      options.site = site;
      expectSound(sharedRenderer().renderer->render(options, {Aov::Radiance, Aov::Exitance}).images,
                  what + (transport == Transport::Dipole ? ", dipole" : ", boundary"));
    }
}

std::vector<fs::path> sharedModels() {
  std::vector<fs::path> models;
  const auto folder = modelsFolder();
  if (!folder) return models;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(*folder)) {
    const fs::path kind = entry.path().extension();
    if (kind == ".ply" || kind == ".obj" || kind == ".glb" || kind == ".gltf")
      models.push_back(entry.path());
  }
  std::sort(models.begin(), models.end());
  return models;
}

template <typename Change>
RenderOptions changed(const Change& change) {
  RenderOptions options = smallOptions();
  change(options);
  return options;
}

TEST_F(RobustnessTest, OptionsOutOfRangeAreRefused) {
  renderer().setScene(plainBall());
  const std::vector<RenderOptions> wrong{
      changed([](RenderOptions& o) { o.width = 0; }),
      changed([](RenderOptions& o) { o.width = 16385; }),
      changed([](RenderOptions& o) { o.height = -3; }),
      changed([](RenderOptions& o) { o.dsmSize = 63; }),
      changed([](RenderOptions& o) { o.dsmSize = 4097; }),
      changed([](RenderOptions& o) { o.shadowSize = 32; }),
      changed([](RenderOptions& o) { o.shadowSize = 8193; }),
      changed([](RenderOptions& o) { o.roughness = 0.01F; }),
      changed([](RenderOptions& o) { o.roughness = nan; }),
      changed([](RenderOptions& o) { o.tolerance = 0; }),
      changed([](RenderOptions& o) { o.tolerance = 1.1F; }),
      changed([](RenderOptions& o) { o.tolerance = nan; }),
      changed([](RenderOptions& o) { o.maxSurfels = 1023; }),
      changed([](RenderOptions& o) { o.maxSurfels = -1; }),
      changed([](RenderOptions& o) { o.maxSurfels = (1 << 22) + 1; }),
      changed([](RenderOptions& o) { o.maxClusters = 63; }),
      changed([](RenderOptions& o) { o.maxClusters = (1 << 18) + 1; }),
      changed([](RenderOptions& o) { o.bounces = -1; }),
      changed([](RenderOptions& o) { o.bounces = 9; }),
      changed([](RenderOptions& o) {
        o.transport = Transport::Boundary;
        o.sum = Sum::Pattern;
      }),
      changed([](RenderOptions& o) { o.antialias = 3; }),
      changed([](RenderOptions& o) { o.antialias = 0; }),
      changed([](RenderOptions& o) { o.pattern.nearRings = 17; }),
      changed([](RenderOptions& o) { o.pattern.nearRings = -1; }),
      changed([](RenderOptions& o) { o.pattern.nearSpacing = 0; }),
      changed([](RenderOptions& o) { o.pattern.nearSpacing = nan; }),
      changed([](RenderOptions& o) { o.pattern.farDistance = 1001; }),
      changed([](RenderOptions& o) { o.transport = static_cast<Transport>(99); }),
      changed([](RenderOptions& o) { o.sum = static_cast<Sum>(-1); }),
      changed([](RenderOptions& o) { o.site = static_cast<Site>(3); }),
  };
  for (std::size_t i = 0; i < wrong.size(); ++i)
    EXPECT_THROW(renderer().render(wrong[i]), UsageError) << i;
  for (const Aov unknown : {static_cast<Aov>(99), static_cast<Aov>(-1)})
    EXPECT_THROW(renderer().render(smallOptions(), {unknown}), UsageError);
  const SceneTime times[] = {{.seconds = -1}, {.seconds = nan}, {.clip = 1}, {.clip = -2}};
  for (const SceneTime& time : times) EXPECT_THROW(renderer().setTime(time), UsageError);
  EXPECT_EQ(render(smallOptions(), {Aov::Depth}).size(), 1U);  // and still works afterwards
}

template <typename Change>
Scene changedScene(const Change& change) {
  Scene scene = plainBall();
  change(scene);
  return scene;
}

TEST_F(RobustnessTest, ScenesThatMakeNoSenseAreRefused) {
  const std::vector<Scene> wrong{
      Scene{},
      changedScene([](Scene& s) { s.objects[0].mesh = {}; }),
      changedScene([](Scene& s) { s.objects[0].mesh.positionsMm[7][1] = nan; }),
      changedScene([](Scene& s) { s.objects[0].mesh.positionsMm[0][2] = infinity; }),
      changedScene([](Scene& s) { s.objects[0].mesh.positionsMm[0][2] = 1e30F; }),
      changedScene([](Scene& s) { s.objects[0].mesh.normals[3][0] = nan; }),
      changedScene([](Scene& s) { s.objects[0].mesh.normals.pop_back(); }),
      changedScene([](Scene& s) { s.objects[0].mesh.triangles[5][1] = 1'000'000; }),
      changedScene([](Scene& s) { s.objects[0].medium.eta = 0.5; }),
      changedScene([](Scene& s) { s.objects[0].medium.sigmaAPerMm[1] = -1; }),
      changedScene([](Scene& s) {
        s.objects[0].medium.sigmaSPrimePerMm = {0, 0, 0};
      }),
      changedScene([](Scene& s) { s.lighting.directional.resize(17); }),
      changedScene([](Scene& s) { s.lighting.points.resize(9); }),
      changedScene([](Scene& s) {
        s.lighting.directional[0].directionToLight = {0, 0, 0};
      }),
      changedScene([](Scene& s) { s.lighting.directional[0].irradiance[1] = nan; }),
      changedScene([](Scene& s) {
        s.lighting.points = {{{0, nan, 0}, {1, 1, 1}}};
      }),
      changedScene([](Scene& s) { s.lighting.ambient[0] = -1; }),
      changedScene([](Scene& s) { s.camera.positionMm = s.camera.targetMm; }),
      changedScene([](Scene& s) { s.camera.verticalFovDegrees = 0; }),
  };
  for (std::size_t i = 0; i < wrong.size(); ++i)
    EXPECT_THROW(renderer().setScene(wrong[i]), Error) << i;
}

/// The ball on one joint with one clip.
Scene riggedBall() {
  Scene scene = plainBall();
  Object& object = scene.objects[0];
  Node node;
  node.morphWeights = {1};
  scene.nodes = {node};
  Rig rig;
  rig.positions = object.mesh.positionsMm;
  rig.normals = object.mesh.normals;
  rig.targets = {{rig.positions, {}}};
  rig.joints.resize(1);
  for (std::uint32_t v = 0; v <= rig.positions.size(); ++v) rig.firstInfluence.push_back(v);
  rig.influences.assign(rig.positions.size(), {0, 1});
  object.rig = rig;
  scene.clips = {
      {"clip", 1, {{0, TrackTarget::Scale, Interpolation::Linear, {0, 1}, {1, 1, 1, 2, 2, 2}}}}};
  return scene;
}

template <typename Change>
Scene changedRig(const Change& change) {
  Scene scene = riggedBall();
  change(scene, *scene.objects[0].rig);
  return scene;
}

TEST_F(RobustnessTest, MotionThatMakesNoSenseIsRefused) {
  const std::vector<Scene> wrong{
      changedRig([](Scene&, Rig& rig) { rig.node = 1; }),
      changedRig([](Scene&, Rig& rig) { rig.positions.pop_back(); }),
      changedRig([](Scene&, Rig& rig) { rig.normals.clear(); }),
      changedRig([](Scene&, Rig& rig) { rig.positions[3][0] = nan; }),
      changedRig([](Scene&, Rig& rig) { rig.targets[0].positions.pop_back(); }),
      changedRig([](Scene&, Rig& rig) { rig.targets[0].normals.resize(1); }),
      changedRig([](Scene&, Rig& rig) { rig.firstInfluence.pop_back(); }),
      changedRig([](Scene&, Rig& rig) { rig.firstInfluence[5] = 1'000'000; }),
      changedRig([](Scene&, Rig& rig) { rig.influences[2].joint = 1; }),
      changedRig([](Scene&, Rig& rig) { rig.influences[2].weight = infinity; }),
      changedRig([](Scene&, Rig& rig) { rig.joints[0].node = 9; }),
      changedRig([](Scene&, Rig& rig) { rig.joints[0].inverseBind.columns[1][1] = nan; }),
      changedRig([](Scene&, Rig& rig) { rig.toScene.columns[3][0] = infinity; }),
      changedRig([](Scene& s, Rig&) { s.nodes[0].parent = 0; }),
      changedRig([](Scene& s, Rig&) { s.nodes[0].parent = -2; }),
      changedRig([](Scene& s, Rig&) { s.nodes[0].rotation[3] = nan; }),
      changedRig([](Scene& s, Rig&) { s.clips[0].seconds = nan; }),
      changedRig([](Scene& s, Rig&) { s.clips[0].tracks[0].node = 1; }),
      changedRig([](Scene& s, Rig&) {
        s.clips[0].tracks[0].seconds = {1, 0};
      }),
      changedRig([](Scene& s, Rig&) { s.clips[0].tracks[0].seconds.clear(); }),
      changedRig([](Scene& s, Rig&) { s.clips[0].tracks[0].values.pop_back(); }),
      changedRig([](Scene& s, Rig&) { s.clips[0].tracks[0].values[0] = nan; }),
      changedRig([](Scene& s, Rig&) { s.clips[0].tracks[0].target = static_cast<TrackTarget>(4); }),
      changedRig([](Scene& s, Rig&) {
        s.clips[0].tracks[0].interpolation = static_cast<Interpolation>(-1);
      }),
      changedRig([](Scene& s, Rig&) { s.deformers.resize(9); }),
      changedRig([](Scene& s, Rig&) {
        s.deformers = {{DeformerKind::Twist, nan, 0}};
      }),
      changedRig([](Scene& s, Rig&) {
        s.deformers = {{DeformerKind::Squash, 1, 0}};
      }),
      changedRig([](Scene& s, Rig&) {
        s.deformers = {{DeformerKind::Bend, 1, -1}};
      }),
  };
  EXPECT_NO_THROW(renderer().setScene(riggedBall()));
  for (std::size_t i = 0; i < wrong.size(); ++i)
    EXPECT_THROW(renderer().setScene(wrong[i]), Error) << i;
}

// 6 million deltas of 28 bytes exceed what any device here can read from one buffer.
TEST_F(RobustnessTest, ASceneThatDoesNotFitLeavesNone) {
  Scene scene = riggedBall();
  Rig& rig = *scene.objects[0].rig;
  rig.targets.assign(6'000'000 / rig.positions.size(), rig.targets[0]);
  Renderer fresh(sharedRenderer().options());
  fresh.setScene(riggedBall());
  try {
    fresh.setScene(scene);
  } catch (const Error&) {
    EXPECT_THROW(fresh.render(smallOptions()), Error);
    EXPECT_THROW(fresh.replacePositions(0, rig.positions), Error);
  }
  fresh.setScene(riggedBall());
  EXPECT_NO_THROW(fresh.render(smallOptions(), {Aov::Depth}));
}

// A body that has shrunk to a point, or grown beyond the range of floats, causes no NaN.
TEST_F(RobustnessTest, MotionWithoutMeasureIsBorne) {
  Scene scene = riggedBall();
  for (const bool parallel : {false, true})
    for (const float scale : {0.0F, 1e-20F, 1e10F, 1e20F, 3e38F}) {
      scene.clips[0].tracks[0].values = {scale, scale, scale, 1, 1, 1};
      if (parallel) scene.camera.orthographicHeightMm = 12.0F;
      renderer().setScene(scene);
      expectLightIsSound("scale " + std::to_string(scale));
    }
}

// Such a camera shows bodies of any size, since its near plane does not move away with them.
TEST_F(RobustnessTest, AFarVertexIsSeenOrthographicallyOrRefused) {
  Scene scene = plainBall();
  scene.lighting.ambient = {1, 1, 1};
  scene.camera.orthographicHeightMm = 12.0F;
  renderer().setScene(scene);
  std::vector<Vec3> positions = scene.objects[0].mesh.positionsMm;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const float side : {-1.0F, 1.0F}) {
      positions[0] = {};
      positions[0][axis] = side * 9e8F;
      renderer().replacePositions(0, positions);
      expectLightIsSound("a vertex far along axis " + std::to_string(axis));
      for (const float beyond : {1.1e9F, 1e11F, 1e30F, infinity, nan}) {
        positions[0][axis] = side * beyond;
        EXPECT_THROW(renderer().replacePositions(0, positions), UsageError) << beyond;
      }
    }
}

TEST_F(RobustnessTest, NothingIsRenderedWithoutAScene) {
  Renderer fresh(sharedRenderer().options());
  EXPECT_THROW(fresh.render(smallOptions()), Error);
}

TEST_F(RobustnessTest, AsManyLightsAsThereMayBe) {
  Scene scene = plainBall();
  scene.lighting.directional.assign(8, {{0, 0, 1}, {1, 1, 1}});
  scene.lighting.points.assign(6, {{3, 4, 15}, {50, 50, 50}});
  const Image many = render(scene, smallOptions(), {Aov::DsmIrradiance})[0];
  scene.lighting.directional.assign(1, {{0, 0, 1}, {8, 8, 8}});
  scene.lighting.points.assign(1, {{3, 4, 15}, {300, 300, 300}});
  const Image few = render(scene, smallOptions(), {Aov::DsmIrradiance})[0];
  forEachCovered(many, [&](std::size_t i) {
    ASSERT_NEAR(many.rgba[i], few.rgba[i], 1e-5F * (1 + few.rgba[i]));
  });
}

TEST_F(RobustnessTest, SizesAtTheEdges) {
  struct Sizes {
    int width, height, dsm, shadow;
  };
  renderer().setScene(plainBall());
  for (const Sizes& sizes : {Sizes{1, 1, 64, 64},
                             {3, 500, 128, 64},
                             {500, 3, 128, 256},
                             {33, 17, 1024, 128},
                             {17, 65, 64, 2048}}) {
    RenderOptions options = smallOptions();
    options.width = sizes.width;
    options.height = sizes.height;
    options.dsmSize = sizes.dsm;
    options.shadowSize = sizes.shadow;
    const auto images = render(options, {Aov::Radiance, Aov::Exitance, Aov::DsmArea});
    ASSERT_EQ(images[0].width, sizes.width);
    ASSERT_EQ(images[0].height, sizes.height);
    ASSERT_EQ(images[2].width, sizes.dsm);
    for (const Image& image : images) {
      EXPECT_GT(forEachCovered(image, [](std::size_t) {}), 0);
      for (const float value : image.rgba) ASSERT_TRUE(std::isfinite(value) && value >= 0);
    }
  }
}

TEST_F(RobustnessTest, TrianglesWithoutAreaAndIsolatedVerticesAreBorne) {
  Scene scene = plainBall();
  Mesh& mesh = scene.objects[0].mesh;
  mesh.triangles.push_back({0, 0, 1});
  mesh.triangles.push_back({4, 4, 4});
  mesh.positionsMm.push_back({1, 1, 1});
  mesh.normals.push_back({0, 0, 1});
  renderer().setScene(scene);
  expectLightIsSound("triangles without area");
}

// Bodies without an inside or with a difficult one, and media at the limits of their range.
TEST_F(RobustnessTest, AwkwardBodiesAreBorne) {
  for (const awkward::Shape& shape : awkward::all()) {
    if (shape.triangles.empty()) continue;
    Scene scene = plainBall();
    scene.objects[0].mesh = {shape.positions, {}, shape.triangles};
    scene.objects[0].mesh.normals.assign(shape.positions.size(), {0, 0, 1});
    renderer().setScene(scene);
    expectLightIsSound(shape.name);
  }
  for (const double scattering : {1e-3, 0.05, 100.0})
    for (const double absorption : {0.0, 0.01, 10.0}) {
      Scene scene = plainBall();
      Medium& medium = scene.objects[0].medium;
      medium.sigmaSPrimePerMm = {scattering, scattering, 1};
      medium.sigmaAPerMm = {absorption, 2 * absorption, absorption};
      renderer().setScene(scene);
      expectLightIsSound("scattering " + std::to_string(scattering) + ", absorption " +
                         std::to_string(absorption));
    }
}

// Work groups list what pixels see in any order. The result must not depend on it.
TEST_F(RobustnessTest, TheSamePictureIsTheSameBitByBit) {
  Scene scene = sceneOf(sphere({0, 0, 0}, 40), marble(), {0, 0, 160}, 45);
  scene.lighting.ambient = {0.5F, 0.4F, 0.3F};
  renderer().setScene(scene);
  RenderOptions options = smallOptions();
  options.width = options.height = 48;
  options.site = Site::Fragment;
  options.maxSurfels = 1024;
  View view(renderer(), options);
  const auto radiance = [&] { return view.render({.aovs = {Aov::Radiance}}).images[0].rgba; };
  const std::vector<float> first = radiance();
  for (int i = 0; i < 30; ++i) ASSERT_EQ(radiance(), first) << i;
}

// All shared models, open and closed.
TEST_F(RobustnessTest, SharedModelsAreBorne) {
  const std::vector<fs::path> models = sharedModels();
  if (models.empty())
    GTEST_SKIP() << "the shared models are not here; set OPALINE_MODELS to their folder";
  for (const fs::path& file : models) {
    LoadOptions load;
    load.diagonalMm = 50;
    load.medium = marble();
    Scene scene = loadScene(file, load);
    scene.lighting = plainBall().lighting;
    renderer().setScene(scene);
    RenderOptions options = smallOptions();
    options.transport = Transport::Boundary;
    options.maxClusters = 256;
    options.maxSurfels = 4096;
    expectSound(render(options, {Aov::Radiance, Aov::Exitance}), file.filename().string());
  }
}

}  // namespace
}  // namespace opaline
