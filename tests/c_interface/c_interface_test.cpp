#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "c_interface/c_fixture.h"

namespace opaline_c_test {
namespace {

TEST(CInterface, DrawsWhatTheCppInterfaceDraws) {
  const Body body;
  const Drawn drawn(sceneOf(body));
  const std::vector<float> picture = drawn.picture();
  EXPECT_EQ(picture, samePicture(sameScene(body), drawn));
  EXPECT_GT(*std::max_element(picture.begin(), picture.end()), 0);
}

TEST(CInterface, MovesVerticesOfAnyStride) {
  Body body;
  const Scene scene = sceneOf(body);
  const Drawn drawn(scene);
  const std::vector<float> atRest = drawn.picture(OpalineAovPosition);
  for (auto& vertex : body.vertices) vertex[1] *= 0.5F;
  ASSERT_EQ(opalineSetPositions(drawn.renderer.get(), 0, body.vertices[0].data(), Body::count,
                                sizeof body.vertices[0]),
            OpalineOk);
  const std::vector<float> flat = drawn.picture(OpalineAovPosition);
  float highest = 0;
  for (std::size_t i = 0; i < floats; i += 4) {
    if (flat[i + 3] > 0) highest = std::max(highest, flat[i + 1]);
  }
  EXPECT_GT(highest, 3);
  EXPECT_LE(highest, 5.001F);
  ASSERT_EQ(opalineRestorePositions(drawn.renderer.get(), 0), OpalineOk);
  EXPECT_EQ(drawn.picture(OpalineAovPosition), atRest);
}

TEST(CInterface, CollectsFramesInTheirOrder) {
  Body body;
  const Drawn drawn(sceneOf(body));
  const OpalineAov aov = OpalineAovDepth;
  std::vector<std::vector<float>> expected;
  std::vector<std::vector<float>> collected;
  const auto squash = [&](float factor) {
    for (std::size_t i = 0; i < Body::count; ++i)
      body.vertices[i][2] = Body().vertices[i][2] * factor;
    ASSERT_EQ(opalineSetPositions(drawn.renderer.get(), 0, body.vertices[0].data(), Body::count,
                                  sizeof body.vertices[0]),
              OpalineOk);
  };
  for (const float factor : {1.F, 0.5F}) {
    squash(factor);
    expected.push_back(drawn.picture(aov));
  }
  for (const float factor : {1.F, 0.5F}) {
    squash(factor);
    ASSERT_EQ(opalineSubmit(drawn.view.get(), &aov, 1), OpalineOk);
  }
  EXPECT_EQ(opalineSubmit(drawn.view.get(), &aov, 1), OpalineBadUse);
  for (int i = 0; i < 2; ++i) {
    std::vector<float> rgba(floats);
    const OpalineTarget target{sizeof target, aov, rgba.data(), rgba.size()};
    double milliseconds = -1;
    ASSERT_EQ(opalineCollect(drawn.view.get(), &target, 1, &milliseconds), OpalineOk);
    EXPECT_GE(milliseconds, 0);
    collected.push_back(rgba);
  }
  EXPECT_EQ(collected, expected);
  EXPECT_NE(expected[0], expected[1]);
}

TEST(CInterface, RefusesWhatMakesNoSense) {
  const Body body;
  const Scene scene = sceneOf(body);
  OpalineMedium medium{};
  EXPECT_EQ(opalineFindMedium("marble", &medium), OpalineBadUse) << "a struct without its size";
  medium.size = sizeof medium + 8;
  EXPECT_EQ(opalineFindMedium("marble", &medium), OpalineBadUse);
  medium.size = sizeof medium;
  EXPECT_EQ(opalineFindMedium("marble", &medium), OpalineOk);
  EXPECT_EQ(opalineFindMedium("granite", &medium), OpalineBadUse);
  EXPECT_NE(std::string(opalineLastError()).find("granite"), std::string::npos);
  EXPECT_EQ(opalineFindMedium(nullptr, &medium), OpalineBadUse);
  EXPECT_EQ(opalineFindMedium("marble", nullptr), OpalineBadUse);
  medium.eta = 0;
  EXPECT_EQ(opalineSetObjectMedium(scene.get(), 0, &medium), OpalineBadUse);
  EXPECT_EQ(opalineSetObjectMedium(nullptr, 0, &medium), OpalineBadUse);

  OpalineObject object = body.object();
  object.triangleCount = 1;
  const std::array<std::uint32_t, 3> beyond{0, 1, 6};
  object.triangles = beyond.data();
  EXPECT_EQ(opalineAddObject(scene.get(), &object, nullptr), OpalineBadUse);
  Body broken;
  broken.vertices[3][1] = std::numeric_limits<float>::quiet_NaN();
  object = broken.object();
  EXPECT_EQ(opalineAddObject(scene.get(), &object, nullptr), OpalineBadUse);
  object = body.object();
  object.positionStrideBytes = 8;
  EXPECT_EQ(opalineAddObject(scene.get(), &object, nullptr), OpalineBadUse);
  std::size_t count = 0;
  EXPECT_EQ(opalineObjectCount(scene.get(), &count), OpalineOk);
  EXPECT_EQ(count, 1U);

  OpalineScene* none = nullptr;
  EXPECT_EQ(opalineLoadScene("no_such_file.ply", nullptr, &none), OpalineFailed);
  EXPECT_NE(std::string(opalineLastError()).find("no_such_file.ply"), std::string::npos);
  EXPECT_EQ(none, nullptr);

  const Drawn drawn(scene);
  std::vector<float> rgba(floats);
  OpalineTarget target{sizeof target, OpalineAovRadiance, rgba.data(), floats - 1};
  EXPECT_EQ(opalineRender(drawn.view.get(), &target, 1), OpalineBadUse);
  target.floatCount = floats;
  const int unknown = 77;
  std::memcpy(&target.aov, &unknown, sizeof unknown);
  EXPECT_EQ(opalineRender(drawn.view.get(), &target, 1), OpalineBadUse);
  EXPECT_EQ(opalineRender(drawn.view.get(), &target, 0), OpalineBadUse);
  EXPECT_EQ(opalineSetPositions(drawn.renderer.get(), 0, body.vertices[0].data(), 5, 28),
            OpalineBadUse);
  EXPECT_EQ(opalineSetPositions(drawn.renderer.get(), 3, body.vertices[0].data(), 6, 28),
            OpalineBadUse);
  OpalineRendererOptions device{};
  device.size = sizeof device;
  EXPECT_EQ(opalineDefaultRendererOptions(&device), OpalineOk);
  device.memoryLimitMegabytes = 1;
  OpalineRenderer* tooSmall = nullptr;
  EXPECT_EQ(opalineCreateRenderer(&device, &tooSmall), OpalineBadUse);
  EXPECT_EQ(tooSmall, nullptr);
  OpalineRenderOptions options = smallDipole();
  options.bounces = 99;
  EXPECT_EQ(opalineSetViewOptions(drawn.view.get(), &options), OpalineBadUse);
  const std::array<float, 3> zero{};
  EXPECT_EQ(opalineAddDirectionalLight(scene.get(), zero.data(), zero.data()), OpalineBadUse);
}

TEST(CInterface, KeepsTheLastErrorOfEachThread) {
  OpalineMedium medium{};
  medium.size = sizeof medium;
  ASSERT_EQ(opalineFindMedium("granite", &medium), OpalineBadUse);
  const std::string here = opalineLastError();
  std::thread([&] {
    EXPECT_STREQ(opalineLastError(), "");
    OpalineMedium other{};
    other.size = sizeof other;
    EXPECT_EQ(opalineFindMedium("basalt", &other), OpalineBadUse);
  }).join();
  EXPECT_EQ(opalineLastError(), here);
}

TEST(CInterface, ReadsStructsOfTheirOwnSizeFromAnArray) {
  const Body body;
  const Drawn drawn(sceneOf(body));
  std::vector<float> a(floats);
  std::vector<float> b(floats);
  const std::array<OpalineTarget, 2> targets{
      {{sizeof(OpalineTarget), OpalineAovNormal, a.data(), floats},
       {sizeof(OpalineTarget), OpalineAovDepth, b.data(), floats}}};
  ASSERT_EQ(opalineRender(drawn.view.get(), targets.data(), targets.size()), OpalineOk);
  EXPECT_EQ(a, drawn.picture(OpalineAovNormal));
  EXPECT_EQ(b, drawn.picture(OpalineAovDepth));
}

TEST(CInterface, ComparesLikeTheFormula) {
  // Both cover two pixels, with errors of 1 and 0 in every channel against 1 and 3.
  const std::vector<float> a{2, 2, 2, 1, 3, 3, 3, 1, 9, 9, 9, 0};
  const std::vector<float> b{1, 1, 1, 1, 3, 3, 3, 1, 0, 0, 0, 1};
  OpalineDifference difference{};
  difference.size = sizeof difference;
  ASSERT_EQ(opalineCompare(a.data(), b.data(), 3, 1, &difference), OpalineOk);
  EXPECT_EQ(difference.coveredPixels, 2U);
  EXPECT_NEAR(difference.relRmse, std::sqrt(0.5) / 2, 1e-6);
  EXPECT_NEAR(difference.relBias, 0.25, 1e-6);
  EXPECT_EQ(difference.maxAbs, 1);
}

TEST(CInterface, NamesItsMedia) {
  ASSERT_EQ(opalineMediumCount(), 18U);
  for (std::size_t i = 0; i < opalineMediumCount(); ++i) {
    OpalineMedium medium{};
    medium.size = sizeof medium;
    EXPECT_EQ(opalineFindMedium(opalineMediumName(i), &medium), OpalineOk);
  }
  EXPECT_EQ(opalineMediumName(18), nullptr);
  OpalineMedium marble{};
  marble.size = sizeof marble;
  ASSERT_EQ(opalineFindMedium("Marble", &marble), OpalineOk);  // Jensen et al. 2001, Figure 5
  EXPECT_EQ(marble.sigmaSPrimePerMm[1], 2.62);
  EXPECT_EQ(marble.sigmaAPerMm[0], 0.0021);
}

}  // namespace
}  // namespace opaline_c_test
