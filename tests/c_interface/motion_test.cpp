#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "c_interface/c_fixture.h"
#include "core/temporary_folder.h"
#include "opaline/soft_body.h"

namespace opaline_c_test {
namespace {

TEST(CInterfaceMotion, DeformersMoveVerticesAsTheirFormulaSays) {
  const Scene scene = sceneOf(Body());
  ASSERT_EQ(opalineAddDeformer(scene.get(), OpalineSquash, 0.5F, 0), OpalineOk);
  std::array<float, 18> positions{};
  ASSERT_EQ(opalinePositionsAt(scene.get(), 0, -1, 0, positions.data(), Body::count), OpalineOk)
      << opalineLastError();
  const auto vertex = [&](std::size_t i) { return &positions[3 * i]; };
  EXPECT_NEAR(vertex(2)[1] - vertex(3)[1], 10, 1e-4F) << "half of 20";
  EXPECT_NEAR(vertex(0)[0] - vertex(1)[0], 20 * std::sqrt(2.F), 1e-4F) << "the volume stays";
  EXPECT_EQ(opalinePositionsAt(scene.get(), 0, -1, 0, positions.data(), 5), OpalineBadUse);
  EXPECT_EQ(opalinePositionsAt(scene.get(), 0, 3, 0, positions.data(), Body::count), OpalineBadUse);
  EXPECT_EQ(opalinePositionsAt(scene.get(), 0, -1, 1, positions.data(), Body::count),
            OpalineBadUse);
  EXPECT_EQ(opalineAddDeformer(scene.get(), OpalineBend, 7, 0), OpalineBadUse);
  EXPECT_NE(std::string(opalineLastError()), "");

  const Drawn drawn(sceneOf(Body()));
  const std::vector<float> atRest = drawn.picture(OpalineAovDepth);
  ASSERT_EQ(opalineSetDeformers(drawn.renderer.get(), scene.get()), OpalineOk);
  EXPECT_NE(drawn.picture(OpalineAovDepth), atRest);
  ASSERT_EQ(opalineClearDeformers(scene.get()), OpalineOk);
  ASSERT_EQ(opalineSetDeformers(drawn.renderer.get(), scene.get()), OpalineOk);
  EXPECT_EQ(drawn.picture(OpalineAovDepth), atRest);
}

// Octahedra that grow from file to file.
void writeMeshes(const std::filesystem::path& folder, int first, int last) {
  const Body body;
  for (int number = first; number <= last; ++number) {
    std::ofstream to(folder / ("mesh_" + std::to_string(number) + ".obj"));
    for (const auto& vertex : body.vertices)
      to << "v " << vertex[0] << ' ' << static_cast<float>(number) * vertex[1] << ' ' << vertex[2]
         << '\n';
    for (std::size_t i = 0; i < body.triangles.size(); i += 3)
      to << "f " << body.triangles[i] + 1 << ' ' << body.triangles[i + 1] + 1 << ' '
         << body.triangles[i + 2] + 1 << '\n';
  }
}

TEST(CInterfaceMotion, SequencesAreReadFileByFile) {
  const opaline::test::TemporaryFolder folder;
  writeMeshes(folder.path(), 3, 5);
  OpalineSequence* sequence = nullptr;
  const std::string pattern = (folder.path() / "mesh_%d.obj").string();
  ASSERT_EQ(opalineOpenSequence(pattern.c_str(), nullptr, &sequence), OpalineOk)
      << opalineLastError();
  const std::unique_ptr<OpalineSequence, decltype(&opalineDestroySequence)> owned(
      sequence, &opalineDestroySequence);
  std::int32_t first = 0;
  std::int32_t last = 0;
  ASSERT_EQ(opalineSequenceNumbers(sequence, &first, &last), OpalineOk);
  EXPECT_EQ(first, 3);
  EXPECT_EQ(last, 5);
  OpalineScene* made = nullptr;
  ASSERT_EQ(opalineSequenceScene(sequence, &made), OpalineOk);
  const Scene scene(made);
  OpalineObjectFacts facts{};
  facts.size = sizeof facts;
  ASSERT_EQ(opalineObjectFacts(made, 0, &facts), OpalineOk);
  ASSERT_EQ(facts.triangleCount, 8U);
  std::vector<std::uint32_t> triangles(3 * facts.triangleCount);
  ASSERT_EQ(opalineObjectTriangles(made, 0, triangles.data(), facts.triangleCount), OpalineOk);
  EXPECT_LT(*std::max_element(triangles.begin(), triangles.end()), facts.vertexCount);

  std::vector<float> positions(3 * facts.vertexCount);
  const auto heightOf = [&](int number) {
    EXPECT_EQ(opalineReadSequence(sequence, number, positions.data(), facts.vertexCount), OpalineOk)
        << opalineLastError();
    float highest = 0;
    for (std::size_t i = 1; i < positions.size(); i += 3) highest = std::max(highest, positions[i]);
    return highest;
  };
  EXPECT_NEAR(heightOf(5) / heightOf(3), 5. / 3, 1e-5);
  EXPECT_EQ(opalineReadSequence(sequence, 6, positions.data(), facts.vertexCount), OpalineBadUse);
  EXPECT_EQ(opalineReadSequence(sequence, 4, positions.data(), 1), OpalineBadUse);
  OpalineSequence* none = nullptr;
  EXPECT_EQ(opalineOpenSequence("no_such_%d.obj", nullptr, &none), OpalineFailed);
  EXPECT_EQ(none, nullptr);
}

TEST(CInterfaceMotion, SoftBodiesMoveAsThoseOfTheCppInterface) {
  const Body body;
  const Scene scene = sceneOf(body);
  const Drawn drawn(scene);
  const std::vector<float> atRest = drawn.picture(OpalineAovPosition);
  OpalineSoftBodyOptions options{};
  options.size = sizeof options;
  ASSERT_EQ(opalineDefaultSoftBodyOptions(&options), OpalineOk);
  options.cells = 4;
  OpalineSoftBody* made = nullptr;
  ASSERT_EQ(opalineCreateSoftBody(drawn.renderer.get(), scene.get(), 0, &options, &made), OpalineOk)
      << opalineLastError();
  std::unique_ptr<OpalineSoftBody, decltype(&opalineDestroySoftBody)> soft(made,
                                                                           &opalineDestroySoftBody);
  const opaline::Scene same = sameScene(body);
  opaline::Renderer renderer;
  renderer.setScene(same);
  opaline::SoftBodyOptions sameOptions;
  sameOptions.cells = 4;
  opaline::SoftBody sameBody(renderer, 0, same.objects[0].mesh.positionsMm,
                             same.objects[0].mesh.triangles, sameOptions);

  const std::array<float, 3> top{0, 10, 0};
  const std::array<float, 3> beside{6, 10, 0};
  ASSERT_EQ(opalineGrabSoftBody(made, top.data(), 2), OpalineOk);
  ASSERT_EQ(opalinePullSoftBody(made, beside.data()), OpalineOk);
  ASSERT_EQ(opalineStepSoftBody(made, 0.1), OpalineOk);
  sameBody.grab(top, 2);
  sameBody.pull(beside);
  sameBody.step(0.1);
  const std::vector<float> pulled = drawn.picture(OpalineAovPosition);
  EXPECT_NE(pulled, atRest);
  EXPECT_EQ(pulled, renderer.render(sameDipole(), {opaline::Aov::Position}).images[0].rgba);
  std::int32_t moves = 0;
  ASSERT_EQ(opalineSoftBodyMoves(made, &moves), OpalineOk);
  EXPECT_EQ(moves, 1);
  EXPECT_EQ(opalineReleaseSoftBody(made), OpalineOk);
  EXPECT_EQ(opalineStepSoftBody(made, -1), OpalineBadUse);
  options.cells = 1;
  OpalineSoftBody* none = nullptr;
  EXPECT_EQ(opalineCreateSoftBody(drawn.renderer.get(), scene.get(), 0, &options, &none),
            OpalineBadUse);
  EXPECT_EQ(none, nullptr);
  soft.reset();
  EXPECT_EQ(drawn.picture(OpalineAovPosition), atRest);
}

OpalineCamera orthographicCamera() {
  OpalineCamera camera{};
  camera.size = sizeof camera;
  camera.positionMm[2] = 100;
  camera.up[1] = 1;
  camera.verticalFovDegrees = 30;
  camera.orthographicHeightMm = 24;
  return camera;
}

TEST(CInterfaceCameras, OrthographicOnesSeeAMillimetreAsSoManyPixels) {
  const Drawn drawn(sceneOf(Body()));
  OpalineCamera camera = orthographicCamera();
  ASSERT_EQ(opalineSetViewCamera(drawn.view.get(), &camera), OpalineOk) << opalineLastError();
  const std::vector<float> straight = drawn.picture(OpalineAovPosition);
  std::size_t covered = 0;
  for (std::size_t i = 0; i < floats; i += 4) {
    if (straight[i + 3] == 0) continue;
    ++covered;
    EXPECT_NEAR(straight[i], static_cast<double>(i / 4 % edge) + 0.5 - 12, 1e-3) << "1 mm a pixel";
    EXPECT_NEAR(straight[i + 1], 12 - (static_cast<double>(i / 4 / edge) + 0.5), 1e-3);
  }
  EXPECT_NEAR(static_cast<double>(covered), 200, 21) << "a square of 200 mm²";

  camera.shiftX = 0.25F;
  ASSERT_EQ(opalineSetViewCamera(drawn.view.get(), &camera), OpalineOk);
  const std::vector<float> shifted = drawn.picture(OpalineAovPosition);
  const std::size_t middle = 4 * (edge * (edge / 2) + edge / 2);
  ASSERT_GT(shifted[middle + 3], 0);
  EXPECT_NEAR(std::abs(shifted[middle] - straight[middle]), 6, 1e-3) << "a quarter of 24 pixels";
  camera.orthographicHeightMm = -1;
  EXPECT_EQ(opalineSetViewCamera(drawn.view.get(), &camera), OpalineBadUse);
}

TEST(CInterfaceCameras, ProgramsOfTheFirstVersionStillFit) {
  constexpr std::size_t firstSize = 48;
  const Scene scene = sceneOf(Body());
  OpalineCamera camera = orthographicCamera();
  ASSERT_EQ(opalineSetSceneCamera(scene.get(), &camera), OpalineOk);
  std::memset(&camera, 0x7F, sizeof camera);
  camera.size = firstSize;
  ASSERT_EQ(opalineSceneCamera(scene.get(), &camera), OpalineOk) << opalineLastError();
  EXPECT_EQ(camera.positionMm[2], 100);
  std::array<unsigned char, sizeof camera> bytes{};
  std::memcpy(bytes.data(), &camera, sizeof camera);
  EXPECT_TRUE(std::all_of(bytes.begin() + firstSize, bytes.end(), [](unsigned char byte) {
    return byte == 0x7F;
  })) << "nothing is written beyond what the caller has";
  ASSERT_EQ(opalineSetSceneCamera(scene.get(), &camera), OpalineOk) << "nor read";
  camera.size = sizeof camera;
  ASSERT_EQ(opalineSceneCamera(scene.get(), &camera), OpalineOk);
  EXPECT_EQ(camera.orthographicHeightMm, 0);
}

TEST(CInterfaceLights, SunsAndVisibleAreasAreThoseOfTheCppInterface) {
  const Scene scene = sceneOf(Body());
  const std::array<float, 3> towards{0, 0.6F, 0.8F};
  const std::array<float, 3> white{2, 2, 2};
  const std::array<float, 3> behind{0, 0, -20};
  ASSERT_EQ(opalineClearLights(scene.get()), OpalineOk);
  ASSERT_EQ(opalineAddSun(scene.get(), towards.data(), white.data(), 5), OpalineOk);
  ASSERT_EQ(opalineAddDiscLight(scene.get(), behind.data(), towards.data(), 90, white.data()),
            OpalineOk);
  ASSERT_EQ(opalineSetAreaLight(scene.get(), 0, 1, 1), OpalineOk);
  opaline::Scene same = sameScene(Body());
  same.lighting = {};
  same.lighting.directional.push_back({towards, white, 5});
  same.lighting.areas.push_back(opaline::DiscLight{.centreMm = behind,
                                                   .normal = towards,
                                                   .radiusMm = 90,
                                                   .radiance = white,
                                                   .twoSided = true,
                                                   .visible = true});
  const Drawn drawn(scene);
  const std::vector<float> picture = drawn.picture(OpalineAovRadiance);
  EXPECT_EQ(picture, samePicture(same, drawn, opaline::Aov::Radiance));
  EXPECT_EQ(picture[3], 1) << "the disc behind fills the corner";

  EXPECT_EQ(opalineSetAreaLight(scene.get(), 1, 0, 0), OpalineBadUse);
  ASSERT_EQ(opalineAddSphereLight(scene.get(), behind.data(), 5, white.data()), OpalineOk);
  EXPECT_EQ(opalineSetAreaLight(scene.get(), 1, 1, 0), OpalineBadUse) << "a sphere has one side";
  EXPECT_EQ(opalineAddSun(scene.get(), towards.data(), white.data(), 11), OpalineBadUse);
}

}  // namespace
}  // namespace opaline_c_test
