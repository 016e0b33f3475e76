#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include "c_interface/c_fixture.h"
#include "core/temporary_folder.h"
#include "opaline/framing.h"

namespace opaline_c_test {
namespace {

template <typename T>
T sized() {
  T made{};
  made.size = sizeof made;
  return made;
}

// The paper's pattern, another map, and a variable of the map, whose size is its own.
TEST(CPattern, DrawsWhatTheCppInterfaceDraws) {
  const Body body;
  const Drawn drawn(sceneOf(body));
  auto pattern = sized<OpalinePattern>();
  ASSERT_EQ(opalineDefaultPattern(&pattern), OpalineOk);
  pattern.nearRings = 1;
  pattern.nearSpacing = 5;
  pattern.farDistance = 12;
  pattern.dsmSize = 64;
  OpalineRenderOptions options = smallDipole();
  options.sum = OpalineSumPattern;
  options.pattern = &pattern;
  ASSERT_EQ(opalineSetViewOptions(drawn.view.get(), &options), OpalineOk) << opalineLastError();
  const std::vector<float> picture = drawn.picture();
  std::vector<float> map(std::size_t{4} * 64 * 64);
  OpalineTarget ofMap{sizeof ofMap, OpalineAovDsmPosition, map.data(), map.size() - 1};
  EXPECT_EQ(opalineRender(drawn.view.get(), &ofMap, 1), OpalineBadUse);
  ofMap.floatCount = map.size();
  ASSERT_EQ(opalineRender(drawn.view.get(), &ofMap, 1), OpalineOk) << opalineLastError();

  opaline::RenderOptions same = sameDipole();
  same.sum = opaline::Sum::Pattern;
  same.pattern = {.nearRings = 1, .nearSpacing = 5, .farDistance = 12};
  same.dsmSize = 64;
  opaline::Renderer& renderer = drawn.renderer->renderer;
  const auto expected =
      renderer.render(same, {opaline::Aov::Exitance, opaline::Aov::DsmPosition}).images;
  EXPECT_EQ(picture, expected[0].rgba);
  EXPECT_EQ(map, expected[1].rgba);
  same.pattern = {};
  EXPECT_NE(picture, renderer.render(same, {opaline::Aov::Exitance}).images[0].rgba);
  pattern.nearRings = 16;
  EXPECT_EQ(opalineSetViewOptions(drawn.view.get(), &options), OpalineBadUse);
}

TEST(CPattern, LevelsOfTheTreeAreChosen) {
  const Body body;
  const Drawn drawn(sceneOf(body));
  OpalineRenderOptions options = smallDipole();
  const auto nodesAt = [&](std::int32_t level) {
    options.treeLevel = level;
    EXPECT_EQ(opalineSetViewOptions(drawn.view.get(), &options), OpalineOk);
    const std::vector<float> picture = drawn.picture(OpalineAovSurfels);
    std::vector<float> nodes;
    for (std::size_t i = 0; i < floats; i += 4)
      if (picture[i + 3] > 0) nodes.push_back(picture[i + 2]);
    std::sort(nodes.begin(), nodes.end());
    return std::unique(nodes.begin(), nodes.end()) - nodes.begin();
  };
  EXPECT_EQ(nodesAt(0), 1) << "the object's root";
  EXPECT_GT(nodesAt(64), 1);
}

// Options of a program that was compiled when the struct had 72 bytes.
TEST(CPattern, OptionsOfBeforeStillFit) {
  const Body body;
  const Drawn drawn(sceneOf(body));
  std::vector<char> bytes(sizeof(OpalineRenderOptions), '\x5a');
  auto* old = reinterpret_cast<OpalineRenderOptions*>(bytes.data());
  old->size = 72;
  ASSERT_EQ(opalineDefaultRenderOptions(old), OpalineOk);
  EXPECT_TRUE(std::all_of(bytes.begin() + 72, bytes.end(), [](char c) { return c == '\x5a'; }));
  old->width = old->height = edge;
  old->transport = OpalineTransportDipole;
  EXPECT_EQ(opalineSetViewOptions(drawn.view.get(), old), OpalineOk) << opalineLastError();
  EXPECT_EQ(drawn.view->view.options().treeLevel, 64);
  old->size = 71;
  EXPECT_EQ(opalineSetViewOptions(drawn.view.get(), old), OpalineBadUse);
}

TEST(CReports, SayHowFramesWereMade) {
  const Body body;
  const Drawn drawn(sceneOf(body));
  OpalineView* view = drawn.view.get();
  auto whole = sized<OpalineViewReport>();
  EXPECT_EQ(opalineViewReport(view, &whole), OpalineBadUse) << "before the first frame";
  OpalineRenderOptions options = smallDipole();
  options.transport = OpalineTransportBoundary;
  options.bounces = 1;
  ASSERT_EQ(opalineSetViewOptions(view, &options), OpalineOk);
  std::vector<float> rgba(floats);
  const OpalineTarget target{sizeof target, OpalineAovRadiance, rgba.data(), floats};
  for (const std::int32_t reuse : {0, 1}) {
    auto order = sized<OpalineFrameOrder>();
    const OpalineAov aov = OpalineAovRadiance;
    order.aovs = &aov;
    order.aovCount = 1;
    order.reuseLight = reuse;
    ASSERT_EQ(opalineSubmitOrder(view, &order), OpalineOk) << opalineLastError();
    ASSERT_EQ(opalineCollect(view, &target, 1, nullptr), OpalineOk);
    auto frame = sized<OpalineFrameReport>();
    ASSERT_EQ(opalineFrameReport(view, &frame), OpalineOk);
    EXPECT_GT(frame.milliseconds, 0);
    EXPECT_EQ(frame.provisional, 0);
    EXPECT_EQ(frame.passCount, view->frame.passes.size());
    EXPECT_EQ(frame.solutionCount, reuse ? view->frame.solutions.size() : 2U)
        << "for direct light and a bounce";
    ASSERT_EQ(opalineViewReport(view, &whole), OpalineOk);
    std::string names;
    auto pass = sized<OpalinePassTime>();
    for (std::size_t i = 0; i < frame.passCount; ++i) {
      ASSERT_EQ(opalineFramePass(view, i, &pass), OpalineOk);
      names += std::string(pass.name) + "\n";
    }
    EXPECT_EQ(names.find("gather") == std::string::npos, reuse == 1) << names;
    EXPECT_EQ(opalineFramePass(view, frame.passCount, &pass), OpalineBadUse);
  }
  EXPECT_EQ(whole.transport, OpalineTransportBoundary);
  EXPECT_EQ(whole.sum, OpalineSumTree);
  EXPECT_EQ(whole.triangles, 8U);
  EXPECT_EQ(whole.vertices, 6U);
  EXPECT_GT(whole.sources, 0U);
  EXPECT_GT(whole.clusters, 0U);
  EXPECT_GT(whole.dispatches, 0U);
  EXPECT_GT(whole.peakMemoryMegabytes, 0);
  auto pass = sized<OpalinePassTime>();
  ASSERT_GT(whole.passCount, 0U);
  ASSERT_EQ(opalineViewPass(view, 0, &pass), OpalineOk);
  EXPECT_GT(std::strlen(pass.name), 0U);
  EXPECT_EQ(opalineViewPass(view, whole.passCount, &pass), OpalineBadUse);
  auto device = sized<OpalineDeviceFacts>();
  ASSERT_EQ(opalineViewDevice(view, &device), OpalineOk);
  EXPECT_EQ(device.name, view->view.report().device.name);
  std::uint64_t messages = 7;
  EXPECT_EQ(opalineValidationMessages(drawn.renderer.get(), &messages), OpalineOk);
  EXPECT_EQ(messages, 0U);
}

TEST(CReports, SolutionsAreThoseOfTheFrame) {
  const Body body;
  const Drawn drawn(sceneOf(body));
  OpalineRenderOptions options = smallDipole();
  options.transport = OpalineTransportBoundary;
  ASSERT_EQ(opalineSetViewOptions(drawn.view.get(), &options), OpalineOk);
  const OpalineAov aov = OpalineAovRadiance;
  ASSERT_EQ(opalineSubmit(drawn.view.get(), &aov, 1), OpalineOk);
  std::vector<float> rgba(floats);
  const OpalineTarget target{sizeof target, aov, rgba.data(), floats};
  ASSERT_EQ(opalineCollect(drawn.view.get(), &target, 1, nullptr), OpalineOk);
  auto solution = sized<OpalineSolution>();
  ASSERT_EQ(opalineFrameSolution(drawn.view.get(), 0, &solution), OpalineOk);
  EXPECT_GT(solution.steps, 0);
  EXPECT_GT(solution.residual[1], 0);
  EXPECT_LT(solution.residual[1], 0.1F);
  EXPECT_EQ(opalineFrameSolution(drawn.view.get(), 9, &solution), OpalineBadUse);
}

TEST(CReports, DevicesAreListed) {
  std::size_t count = 0;
  ASSERT_EQ(opalineDeviceCount(&count), OpalineOk);
  const std::vector<opaline::DeviceDescription> devices = opaline::listDevices();
  ASSERT_EQ(count, devices.size());
  auto facts = sized<OpalineDeviceFacts>();
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_EQ(opalineDeviceFacts(i, &facts), OpalineOk);
    EXPECT_EQ(facts.name, devices[i].name);
    EXPECT_EQ(facts.type, devices[i].type);
    EXPECT_EQ(facts.driver, devices[i].driver);
    EXPECT_EQ(facts.rayQueries != 0, devices[i].rayQueries);
  }
  EXPECT_EQ(opalineDeviceFacts(count, &facts), OpalineBadUse);
}

TEST(CScenes, NotesOfLoadingReachTheLog) {
  auto options = sized<OpalineLoadOptions>();
  std::vector<std::string> notes;
  options.logContext = &notes;
  options.log = [](void* context, OpalineLogLevel, const char* message) {
    static_cast<std::vector<std::string>*>(context)->emplace_back(message);
  };
  OpalineScene* scene = nullptr;
  const opaline::test::TemporaryFolder folder;
  const std::string file = (folder / "corner.obj").string();
  std::ofstream(file) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  ASSERT_EQ(opalineLoadScene(file.c_str(), &options, &scene), OpalineOk) << opalineLastError();
  const Scene owned(scene);
  ASSERT_FALSE(notes.empty());
  EXPECT_NE(notes[0].find("unit"), std::string::npos) << notes[0];
}

TEST(CScenes, ACameraSeesAllPoints) {
  const Body body;
  const Scene scene = sceneOf(body);
  auto camera = sized<OpalineCamera>();
  ASSERT_EQ(opalineSceneCamera(scene.get(), &camera), OpalineOk);
  auto moved = sized<OpalineCamera>();
  ASSERT_EQ(opalineCameraThatSees(&camera, 1.5, 0.1, body.vertices[0].data(), Body::count,
                                  sizeof body.vertices[0], &moved),
            OpalineOk)
      << opalineLastError();
  opaline::Framing framing(sameScene(body).camera, 1.5, 0.1);
  for (const auto& vertex : body.vertices) framing.add({vertex[0], vertex[1], vertex[2]});
  const opaline::Camera expected = framing.camera();
  EXPECT_EQ((std::vector<float>(moved.positionMm, moved.positionMm + 3)),
            (std::vector<float>(expected.positionMm.begin(), expected.positionMm.end())));
  EXPECT_NE(moved.positionMm[2], camera.positionMm[2]);
  EXPECT_EQ(opalineCameraThatSees(&camera, 1.5, 1, body.vertices[0].data(), Body::count,
                                  sizeof body.vertices[0], &moved),
            OpalineBadUse)
      << "nothing is left between such margins";
}

}  // namespace
}  // namespace opaline_c_test
