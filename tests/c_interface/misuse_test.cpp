// Invalid calls return a status with one sentence. Nothing invalid is read, and existing objects
// still work.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "c_interface/c_fixture.h"

namespace opaline_c_test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr std::array<float, 4> someVector{1, 2, 3, 1};  // also used as a pixel
constexpr std::array<float, 3> brokenVector{nan, 0, 0};
// A count that is negative in 32 bits, and one that no memory holds.
constexpr std::array<std::size_t, 2> absurdCounts{std::size_t{1} << 31, SIZE_MAX};

struct Misuse {
  const char* name;
  std::function<OpalineStatus()> call;
};

void expectRefused(const std::vector<Misuse>& calls) {
  for (const Misuse& misuse : calls) {
    SCOPED_TRACE(misuse.name);
    EXPECT_EQ(misuse.call(), OpalineBadUse);
    const std::string sentence = opalineLastError();
    EXPECT_GT(sentence.size(), 12U) << sentence;
    EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
    EXPECT_EQ(sentence.find("std::"), std::string::npos) << sentence;
  }
}

TEST(CMisuse, CountsThatCannotBeAreRefusedBeforeAnythingIsRead) {
  const Body body;
  const Scene scene = sceneOf(body);
  const Drawn drawn(scene);
  const float* const some = someVector.data();
  const OpalineAov aov = OpalineAovRadiance;
  std::vector<float> rgba(floats);
  const OpalineTarget target{sizeof target, aov, rgba.data(), floats};
  for (const std::size_t count : absurdCounts) {
    SCOPED_TRACE(count);
    OpalineCamera camera{};
    camera.size = sizeof camera;
    ASSERT_EQ(opalineSceneCamera(scene.get(), &camera), OpalineOk);
    expectRefused({
        {"vertices of an object",
         [&] {
           OpalineObject object = body.object();
           object.vertexCount = count;
           return opalineAddObject(scene.get(), &object, nullptr);
         }},
        {"triangles",
         [&] {
           OpalineObject object = body.object();
           object.triangleCount = count;
           return opalineAddObject(scene.get(), &object, nullptr);
         }},
        {"positions", [&] { return opalineSetPositions(drawn.renderer.get(), 0, some, count, 0); }},
        {"texture coordinates",
         [&] { return opalineSetObjectTextureCoordinates(scene.get(), 0, 0, some, count, 0); }},
        {"colours", [&] { return opalineSetObjectColors(scene.get(), 0, some, count, 0); }},
        {"points to be seen",
         [&] { return opalineCameraThatSees(&camera, 1, 0, some, count, 0, &camera); }},
        {"variables", [&] { return opalineSubmit(drawn.view.get(), &aov, count); }},
        {"targets", [&] { return opalineRender(drawn.view.get(), &target, count); }},
        {"targets of a frame",
         [&] { return opalineCollect(drawn.view.get(), &target, count, nullptr); }},
        {"extensions",
         [&] {
           OpalineRendererOptions options{};
           options.size = sizeof options;
           const char* const none = nullptr;
           options.deviceExtensions = &none;
           options.deviceExtensionCount = count;
           OpalineRenderer* made = nullptr;
           return opalineCreateRenderer(&options, &made);
         }},
    });
  }
  for (const std::int32_t side : {0, -1, std::numeric_limits<std::int32_t>::max()}) {
    SCOPED_TRACE(side);
    OpalinePixels* pixels = nullptr;
    OpalineDifference difference{};
    difference.size = sizeof difference;
    expectRefused({
        {"view",
         [&] {
           OpalineRenderOptions options = smallDipole();
           options.width = side;
           return opalineSetViewOptions(drawn.view.get(), &options);
         }},
        {"pixels", [&] { return opalineCreatePixels(some, 8, side, 1, &pixels); }},
        {"environment",
         [&] { return opalineSetEnvironmentPixels(scene.get(), some, 1, side, 1, 0); }},
        {"PNG", [&] { return opalineWritePng("none.png", some, side, 1, nullptr); }},
        {"EXR", [&] { return opalineWriteExr("none.exr", some, side, 1); }},
        {"comparison", [&] { return opalineCompare(some, some, side, side, &difference); }},
    });
  }
  drawn.picture();
}

TEST(CMisuse, NumbersThatAreNoneAreRefused) {
  const Body body;
  const Scene scene = sceneOf(body);
  const Drawn drawn(scene);
  const float* const broken = brokenVector.data();
  const float* const some = someVector.data();
  OpalineCamera camera{};
  camera.size = sizeof camera;
  ASSERT_EQ(opalineSceneCamera(scene.get(), &camera), OpalineOk);
  const auto matrices = [&](float diagonal, float elsewhere) {
    OpalineCameraMatrices given{};
    given.size = sizeof given;
    for (std::size_t i = 0; i < 16; ++i)
      given.worldToView[i] = given.viewToClip[i] = i % 5 == 0 ? diagonal : elsewhere;
    return opalineSetViewMatrices(drawn.view.get(), &given);
  };
  const auto perspective = [&](float scale) {
    OpalineCameraMatrices given{};
    given.size = sizeof given;
    for (const std::size_t i : {0U, 5U, 10U}) given.worldToView[i] = scale;
    given.viewToClip[0] = given.viewToClip[5] = scale;
    given.worldToView[15] = given.viewToClip[11] = given.viewToClip[14] = 1;
    return opalineSetViewMatrices(drawn.view.get(), &given);
  };
  expectRefused({
      {"matrices of NaN", [&] { return matrices(nan, nan); }},
      {"of infinity", [&] { return matrices(std::numeric_limits<float>::infinity(), 0); }},
      {"of nothing", [&] { return matrices(0, 0); }},
      {"beyond floats", [&] { return perspective(3e38F); }},
      {"below floats", [&] { return perspective(1e-38F); }},
      {"singular", [&] { return matrices(1, 1); }},
      {"camera",
       [&] {
         OpalineCamera given = camera;
         given.positionMm[1] = nan;
         return opalineSetViewCamera(drawn.view.get(), &given);
       }},
      {"direction of a camera",
       [&] { return opalineDefaultCamera(scene.get(), broken, 30, &camera); }},
      {"time", [&] { return opalineSetTime(drawn.renderer.get(), NAN, -1); }},
      {"time of positions",
       [&] { return opalinePositionsAt(scene.get(), NAN, -1, 0, nullptr, 0); }},
      {"deformer", [&] { return opalineAddDeformer(scene.get(), OpalineTwist, nan, 1); }},
      {"point light", [&] { return opalineAddPointLight(scene.get(), broken, some); }},
      {"power of a light", [&] { return opalineAddPointLight(scene.get(), some, broken); }},
      {"disc", [&] { return opalineAddDiscLight(scene.get(), some, some, nan, some); }},
      {"ambient light", [&] { return opalineSetAmbientLight(scene.get(), broken); }},
      {"ground", [&] { return opalineAddGround(scene.get(), broken); }},
      {"environment", [&] { return opalineSetEnvironment(scene.get(), "none.hdr", nan, 0); }},
      {"roughness",
       [&] {
         OpalineRenderOptions options = smallDipole();
         options.roughness = nan;
         return opalineSetViewOptions(drawn.view.get(), &options);
       }},
      {"budget",
       [&] {
         OpalineRendererOptions options{};
         options.size = sizeof options;
         EXPECT_EQ(opalineDefaultRendererOptions(&options), OpalineOk);
         options.memoryLimitMegabytes = nan;
         OpalineRenderer* made = nullptr;
         return opalineCreateRenderer(&options, &made);
       }},
      {"exposure",
       [&] {
         OpalineTone tone{};
         tone.size = sizeof tone;
         tone.exposureStops = nan;
         return opalineWritePng("none.png", some, 1, 1, &tone);
       }},
  });
  drawn.picture();
}

TEST(CMisuse, StructsOfOtherSizesAreRefused) {
  const Body body;
  const Scene scene = sceneOf(body);
  const Drawn drawn(scene);
  std::vector<float> rgba(2 * floats);
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{3}, absurdCounts[0], absurdCounts[1]}) {
    SCOPED_TRACE(size);
    expectRefused({
        {"object",
         [&] {
           OpalineObject object = body.object();
           object.size = size;
           return opalineAddObject(scene.get(), &object, nullptr);
         }},
        {"options of a renderer",
         [&] {
           OpalineRendererOptions options{};
           options.size = size;
           OpalineRenderer* made = nullptr;
           return opalineCreateRenderer(&options, &made);
         }},
        {"options of a view",
         [&] {
           OpalineRenderOptions options = smallDipole();
           options.size = size;
           return opalineSetViewOptions(drawn.view.get(), &options);
         }},
        {"second target",
         [&] {
           const std::array<OpalineTarget, 2> targets{
               {{sizeof(OpalineTarget), OpalineAovRadiance, rgba.data(), floats},
                {size, OpalineAovDepth, rgba.data() + floats, floats}}};
           return opalineRender(drawn.view.get(), targets.data(), targets.size());
         }},
        {"defaults",
         [&] {
           OpalineRenderOptions options{};
           options.size = size;
           return opalineDefaultRenderOptions(&options);
         }},
    });
  }
}

TEST(CMisuse, CallsInTheWrongOrderAreRefused) {
  const Body body;
  const Scene scene = sceneOf(body);
  const Drawn drawn(scene);
  OpalineView* const view = drawn.view.get();
  const std::vector<float> expected = drawn.picture();
  std::vector<float> rgba(floats);
  const OpalineAov aov = OpalineAovExitance;
  const OpalineTarget target{sizeof target, aov, rgba.data(), floats};
  const OpalineTarget narrow{sizeof narrow, aov, rgba.data(), floats - 1};
  const OpalineTarget other{sizeof other, OpalineAovDepth, rgba.data(), floats};
  expectRefused(
      {{"collect before submit", [&] { return opalineCollect(view, &target, 1, nullptr); }}});
  ASSERT_EQ(opalineSubmit(view, &aov, 1), OpalineOk);
  expectRefused({
      {"render before collect", [&] { return opalineRender(view, &target, 1); }},
      {"no target", [&] { return opalineCollect(view, nullptr, 0, nullptr); }},
      {"no room", [&] { return opalineCollect(view, &narrow, 1, nullptr); }},
      {"another variable", [&] { return opalineCollect(view, &other, 1, nullptr); }},
      {"still none", [&] { return opalineCollect(view, &narrow, 1, nullptr); }},
  });
  // The frame has waited for a fitting target.
  ASSERT_EQ(opalineCollect(view, &target, 1, nullptr), OpalineOk) << opalineLastError();
  EXPECT_EQ(rgba, expected);
  expectRefused({{"collect again", [&] { return opalineCollect(view, &target, 1, nullptr); }}});

  // A report belongs to its scene and frames.
  OpalinePassTime pass{};
  pass.size = sizeof pass;
  ASSERT_EQ(opalineViewPass(view, 0, &pass), OpalineOk);
  ASSERT_EQ(opalineSetScene(drawn.renderer.get(), scene.get()), OpalineOk);
  ASSERT_EQ(opalineSubmit(view, &aov, 1), OpalineOk);
  expectRefused({{"report before a frame", [&] { return opalineViewPass(view, 0, &pass); }}});
  ASSERT_EQ(opalineCollect(view, &target, 1, nullptr), OpalineOk);
  EXPECT_EQ(opalineViewPass(view, 0, &pass), OpalineOk);

  OpalineRenderer* made = nullptr;
  ASSERT_EQ(opalineCreateRenderer(nullptr, &made), OpalineOk);
  const Renderer empty(made);
  EXPECT_EQ(opalineSetTime(made, 0, -1), OpalineFailed) << "without a scene";
  EXPECT_EQ(opalineSetPositions(made, 0, someVector.data(), 1, 0), OpalineFailed);
}

TEST(CMisuse, HandlesThatWereDestroyedAreRefused) {
  const Body body;
  const Scene scene = sceneOf(body);
  Drawn drawn(scene);
  std::vector<float> rgba(floats);
  const OpalineTarget target{sizeof target, OpalineAovExitance, rgba.data(), floats};
  OpalineScene* const gone = sceneOf(body).get();
  std::size_t count = 0;
  OpalineView* const view = drawn.view.get();
  expectRefused({
      {"scene", [&] { return opalineObjectCount(gone, &count); }},
      {"view for a scene",
       [&] { return opalineObjectCount(reinterpret_cast<OpalineScene*>(view), &count); }},
      {"struct for a renderer",
       [&] { return opalineSetTime(reinterpret_cast<OpalineRenderer*>(&count), 0, -1); }},
  });
  opalineDestroyScene(gone);
  opalineDestroyScene(reinterpret_cast<OpalineScene*>(view));
  drawn.picture();

  // Views and soft bodies are destroyed with their renderer, whatever is done with them afterwards.
  OpalineSoftBody* softBody = nullptr;
  ASSERT_EQ(opalineCreateSoftBody(drawn.renderer.get(), scene.get(), 0, nullptr, &softBody),
            OpalineOk)
      << opalineLastError();
  OpalineView* second = nullptr;
  ASSERT_EQ(opalineCreateView(drawn.renderer.get(), nullptr, &second), OpalineOk);
  opalineDestroyView(second);
  drawn.renderer.reset();
  expectRefused({
      {"view", [&] { return opalineRender(view, &target, 1); }},
      {"second view", [&] { return opalineRender(second, &target, 1); }},
      {"soft body", [&] { return opalineStepSoftBody(softBody, 0.01); }},
  });
  opalineDestroySoftBody(softBody);
  opalineDestroyView(second);  // and drawn.view again
}

}  // namespace
}  // namespace opaline_c_test
