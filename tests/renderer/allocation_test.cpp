// The frame loop allocates nothing on the heap once it has warmed up.

#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

#include "allocations.h"
#include "caller.h"
#include "opaline/renderer.h"
#include "opaline/scene.h"
#include "opaline/soft_body.h"
#include "renderer/shapes.h"

namespace opaline {
namespace {

using namespace test;

constexpr int warmUp = 4;
constexpr int steady = 4;

Scene moving() {
  Scene scene = sceneOf(sphere({0, 0, 0}, 5, 3), marble(), {0, 0, 25}, 6);
  scene.lighting.directional = {{{0.3F, 0.5F, 0.8F}, {1, 1, 1}}};
  scene.lighting.points = {{{20, 0, 0}, {100, 100, 100}}};
  scene.deformers = {{DeformerKind::Wobble, 0.05F, 1}, {DeformerKind::Squash, 0.3F, 0.7F}};
  Node node;
  node.morphWeights = {0};
  scene.nodes = {node};
  Rig rig;
  rig.positions = scene.objects[0].mesh.positionsMm;
  rig.normals = scene.objects[0].mesh.normals;
  rig.targets.resize(1);
  for (const Vec3& p : rig.positions) rig.targets[0].positions.push_back({0, p[0], 0});
  rig.joints.resize(1);
  for (std::uint32_t v = 0; v <= rig.positions.size(); ++v) {
    rig.firstInfluence.push_back(v);
    if (v < rig.positions.size()) rig.influences.push_back({0, 1});
  }
  scene.objects[0].rig = rig;
  scene.clips = {
      {"all",
       2,
       {{0, TrackTarget::MorphWeights, Interpolation::Linear, {0, 2}, {0, 1}},
        {0, TrackTarget::Rotation, Interpolation::CubicSpline, {0, 2}, {0, 0, 0, 0, 0, 0, 0, 1,
                                                                        0, 0, 0, 0, 0, 0, 0, 0,
                                                                        0, 1, 0, 0, 0, 0, 0, 0}}}}};
  return scene;
}

/// The same with an opaque body, and with everything that a clip can change besides nodes.
Scene changing() {
  Scene scene = moving();
  Object plate;
  plate.name = "plate";
  plate.mesh = sphere({0, -12, 0}, 4, 2);
  plate.opaque = mattMaterial({0.5F, 0.5F, 0.5F});
  scene.objects.push_back(plate);
  OpaqueMaterial red = *plate.opaque;
  red.baseColor = {0.8F, 0.1F, 0.1F};
  Medium dense = scene.objects[0].medium;
  for (double& sigma : dense.sigmaAPerMm) sigma *= 3;
  Camera near = scene.camera;
  near.positionMm[2] *= 0.9F;
  const Lighting& lighting = scene.lighting;
  ClipChanges& changes = scene.changes.emplace_back();
  const auto twice = [](const auto& first, const auto& second) {
    return std::vector{first, second};
  };
  changes.directional = {
      {0, {0, 2}, twice(lighting.directional[0], DirectionalLight{{0, 0, 1}, {2, 1, 1}})}};
  changes.points = {{0, {0, 2}, twice(lighting.points[0], PointLight{{0, 20, 0}, {50, 0, 0}})}};
  changes.cameras = {{0, {0, 2}, twice(scene.camera, near)}};
  changes.surfaces = {{1, {0, 2}, twice(*plate.opaque, red)}};
  changes.media = {{0, {0, 2}, twice(scene.objects[0].medium, dense)}};
  return scene;
}

RenderOptions tinyOptions() {
  RenderOptions options;
  options.width = options.height = 16;
  options.maxSurfels = 1024;  // coarse, but every pass of a frame has work
  options.maxClusters = 128;
  options.dsmSize = 64;
  options.shadowSize = 64;
  return options;
}

/// Counts this thread's allocations in the frames after the warm-up.
template <typename BeforeFrame>
std::size_t allocationsOfSteadyFrames(Renderer& renderer, View& view, const FrameOrder& order,
                                      const BeforeFrame& before) {
  Frame frame;
  std::size_t atFirst = 0;
  for (int i = 0; i < warmUp + steady; ++i) {
    if (i == warmUp) atFirst = allocations();
    renderer.setTime({.seconds = 0.1 * i});
    before();
    view.submit(order);
    if (i > 0) view.collect(frame);
  }
  const std::size_t found = allocations() - atFirst;
  view.collect(frame);
  return found;
}

template <typename BeforeFrame>
std::size_t allocationsOfSteadyFrames(Renderer& renderer, const RenderOptions& options,
                                      const FrameOrder& order, const BeforeFrame& before) {
  View view(renderer, options);
  return allocationsOfSteadyFrames(renderer, view, order, before);
}

TEST(AllocationTest, ClipsThatChangeLightsAndMaterialsAllocateNothing) {
  Renderer renderer;
  renderer.setScene(changing());
  RenderOptions options = tinyOptions();
  for (const Transport transport : {Transport::Dipole, Transport::Boundary}) {
    options.transport = transport;
    EXPECT_EQ(allocationsOfSteadyFrames(renderer, options, {}, [] {}), 0U);
  }
}

// The bytes per frame that the steadiest 20 frames in a row leave in the heap. On a busy machine
// Mesa's software device was seen to keep 200,000 bytes more of most frames for a while, and it
// compiles now and then. So frames are made until 20 leave few enough, but not for ever.
double heapOfSteadyFrames(Renderer& renderer, const RenderOptions& options, double allowed) {
  constexpr std::size_t steadyFrames = 20;
  constexpr std::size_t mostFrames = 120;
  View view(renderer, options);
  std::vector<double> heap;
  double least = std::numeric_limits<double>::infinity();
  while (heap.size() < mostFrames && least > allowed) {
    renderer.setTime({.seconds = 0.1 * static_cast<double>(heap.size())});
    view.render();
    heap.push_back(static_cast<double>(mallinfo2().uordblks));
    if (heap.size() <= steadyFrames) continue;
    const double before = heap[heap.size() - 1 - steadyFrames];
    least = std::min(least, (heap.back() - before) / steadyFrames);
  }
  return least;
}

// The driver must not either, whose C code the counters do not see. Mesa 22.3 compiles shaders
// again in each dispatch, and keeps them, where pushed numbers alone decide most branches: it kept
// half a megabyte a frame for the backdrop, and 15 for area lights on opaque bodies. A sanitizer's
// heap cannot be measured.
TEST(AllocationTest, SteadyFramesLeaveNothingInTheHeap) {
  Scene scene = moving();
  scene.lighting.environment = std::make_shared<Image>(4, 2);
  scene.lighting.areas = {DiscLight{{0, 100, 0}, {0, -1, 0}, 30, {500, 500, 500}}};
  scene.objects.push_back(groundUnder(scene));
  Renderer renderer;
  renderer.setScene(scene);
  RenderOptions options = tinyOptions();
  options.environmentBehind = true;
  constexpr double allowedPerFrame = 50'000;
  for (const Transport transport : {Transport::Dipole, Transport::Boundary})
    for (const Site site : {Site::Vertex, Site::Fragment}) {
      options.transport = transport;
      options.site = site;
      EXPECT_LE(heapOfSteadyFrames(renderer, options, allowedPerFrame), allowedPerFrame)
          << static_cast<int>(transport) << static_cast<int>(site);
    }
}

TEST(AllocationTest, SteadyFramesAllocateNothing) {
  Renderer renderer;
  const Scene scene = moving();
  renderer.setScene(scene);
  RenderOptions options = tinyOptions();
  for (const Transport transport : {Transport::Dipole, Transport::Boundary})
    for (const Sum sum : {Sum::Pattern, Sum::Tree, Sum::All})
      for (const Site site : {Site::Vertex, Site::Fragment, Site::Auto}) {
        if (transport == Transport::Boundary && sum == Sum::Pattern) continue;
        options.transport = transport;
        options.sum = sum;
        options.site = site;
        const auto nothing = [] {};
        View view(renderer, options);
        EXPECT_EQ(allocationsOfSteadyFrames(renderer, view, {.aovs = {}}, nothing), 0U);
        EXPECT_EQ(
            allocationsOfSteadyFrames(
                renderer, view,
                {.aovs = {Aov::Radiance, Aov::Exitance, Aov::Evaluations, Aov::DsmArea}}, nothing),
            0U);
        if (sum == Sum::Pattern) continue;
        EXPECT_EQ(allocationsOfSteadyFrames(renderer, view, {.aovs = {Aov::Surfels}}, nothing), 0U);
      }
}

// Dragging a light rebuilds nothing; its environment is shared, not copied.
TEST(AllocationTest, LightsThatMoveAllocateNothing) {
  Renderer renderer;
  Scene scene = moving();
  scene.lighting.environment = std::make_shared<const Image>(64, 32);
  renderer.setScene(scene);
  const long owners = scene.lighting.environment.use_count();
  EXPECT_GT(owners, 1);
  const auto drag = [&] {
    scene.lighting.points[0].positionMm[1] += 1;
    renderer.setLighting(scene.lighting);
  };
  EXPECT_EQ(allocationsOfSteadyFrames(renderer, tinyOptions(), {}, drag), 0U);
  EXPECT_EQ(scene.lighting.environment.use_count(), owners);
}

TEST(AllocationTest, GivenPositionsAllocateNothing) {
  Renderer renderer;
  const Scene scene = moving();
  renderer.setScene(scene);
  const RenderOptions options = tinyOptions();
  const auto give = [&] { renderer.replacePositions(0, scene.objects[0].mesh.positionsMm); };
  EXPECT_EQ(allocationsOfSteadyFrames(renderer, options, {}, give), 0U);
}

TEST(AllocationTest, SoftBodiesAllocateNothing) {
  Renderer renderer;
  const Scene scene = moving();
  renderer.setScene(scene);
  const Mesh& mesh = scene.objects[0].mesh;
  SoftBody body(renderer, 0, mesh.positionsMm, mesh.triangles);
  body.grab({0, 5, 0}, 1);
  float x = 0;
  const auto pull = [&] {
    body.pull({x += 0.2F, 5, 0});
    body.step(0.02);
  };
  EXPECT_EQ(allocationsOfSteadyFrames(renderer, tinyOptions(), {}, pull), 0U);
  EXPECT_TRUE(body.moves());
}

// Frames that others submit allocate nothing either, whether or not they write exitance into the
// caller's buffers.
TEST(AllocationTest, RecordedFramesAllocateNothing) {
  Renderer renderer;
  renderer.setScene(moving());
  RenderOptions options = tinyOptions();
  options.site = Site::Vertex;
  View view(renderer, options);
  bench::Caller caller(renderer);
  const FrameOrder order{.aovs = {}, .onDevice = true, .exitance = true};
  std::size_t found = 0;
  for (int i = 0; i < warmUp + steady; ++i) {
    renderer.setTime({.seconds = 0.1 * i});
    const FrameRecording recording = caller.begin();
    const std::size_t before = allocations();
    view.record(recording, order);
    if (i >= warmUp) found += allocations() - before;
    caller.submit(recording);
  }
  Frame frame;
  for (int i = 0; i < View::framesInFlight; ++i) view.collect(frame);
  EXPECT_EQ(found, 0U);
}

TEST(AllocationTest, TheCounterCounts) {
  const std::size_t before = allocations();
  delete new int(3);
  const std::vector<double> numbers(7);
  EXPECT_GE(allocations() - before + numbers.size(), 8U);
}

}  // namespace
}  // namespace opaline
