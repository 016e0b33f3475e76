#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "opaline/vulkan.h"
#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"

namespace opaline::test {
namespace {

constexpr Aov both[] = {Aov::Radiance, Aov::Exitance};

std::vector<Aov> asked() {
  return {std::begin(both), std::end(both)};
}

Scene wobblyBall() {
  Scene scene = sceneOf(sphere({0, 0, 0}, 6, 3), marble(), {0, 3, 24}, 7);
  scene.lighting.directional.push_back({{0, 0.6F, -0.8F}, {3, 3, 3}});
  scene.deformers.push_back({DeformerKind::Twist, 0.4F, 0});
  return scene;
}

// What can be edited, done to a scene and to a renderer that shows it.
struct Edit {
  std::string name;
  std::function<void(Scene&)> edit;
  std::function<void(Renderer&, const Scene&)> take;
};

void takeCamera(Renderer& renderer, const Scene& scene) {
  renderer.setCamera(scene.camera);
}
void takeLighting(Renderer& renderer, const Scene& scene) {
  renderer.setLighting(scene.lighting);
}
void takeMedium(Renderer& renderer, const Scene& scene) {
  renderer.setMedium(0, scene.objects[0].medium);
}
void takeDeformers(Renderer& renderer, const Scene& scene) {
  renderer.setDeformers(scene.deformers);
}

Image gradient() {
  Image sky(16, 8);
  for (std::size_t i = 0; i < sky.rgba.size(); ++i)
    sky.rgba[i] = 0.01F * static_cast<float>(i % 97);
  return sky;
}

const std::vector<Edit>& edits() {
  static const std::vector<Edit> list{
      {"camera", [](Scene& s) { s.camera.positionMm[0] += 7; }, takeCamera},
      {"light turns",
       [](Scene& s) {
         s.lighting.directional[0].directionToLight = {0.6F, 0, 0.8F};
         s.lighting.directional[0].irradiance = {3, 2, 1};
       },
       takeLighting},
      {"light comes",
       [](Scene& s) {
         s.lighting.directional.push_back({{0, 1, 0}, {1, 2, 3}});
         s.lighting.points.push_back({{30, 20, 10}, {500, 400, 300}});
       },
       takeLighting},
      {"light goes", [](Scene& s) { s.lighting.directional.clear(); }, takeLighting},
      {"ambient",
       [](Scene& s) {
         s.lighting.ambient = {0.5F, 0.2F, 0.1F};
       },
       takeLighting},
      {"environment",
       [](Scene& s) { s.lighting.environment = std::make_shared<const Image>(gradient()); },
       takeLighting},
      {"coefficients",
       [](Scene& s) {
         s.objects[0].medium.sigmaAPerMm = {0.3, 0.2, 0.1};
       },
       takeMedium},
      {"finer medium",
       [](Scene& s) {
         s.objects[0].medium.sigmaSPrimePerMm = {9, 8, 7};
         s.objects[0].medium.eta = 1.5;
       },
       takeMedium},
      {"deformer", [](Scene& s) { s.deformers[0].amount = -1; }, takeDeformers},
      {"another deformer",
       [](Scene& s) {
         s.deformers.push_back({DeformerKind::Bend, 0.5F, 0});
       },
       takeDeformers},
  };
  return list;
}

struct Method {
  const char* name;
  Transport transport;
  Sum sum;
  Site site;
};

constexpr Method methods[] = {{"boundary", Transport::Boundary, Sum::Tree, Site::Vertex},
                              {"tree", Transport::BetterDipole, Sum::Tree, Site::Fragment},
                              {"pattern", Transport::Dipole, Sum::Pattern, Site::Fragment}};

RenderOptions optionsOf(const Method& method) {
  RenderOptions options = smallOptions();
  options.transport = method.transport;
  options.sum = method.sum;
  options.site = method.site;
  options.maxClusters = 512;
  return options;
}

void expectSame(const std::vector<Image>& a, const std::vector<Image>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].rgba, b[i].rgba) << "image " << i;
}

class EditTest : public RendererTestBase<testing::TestWithParam<Method>> {};

// The same bits as from the edited scene, whatever was shown before.
TEST_P(EditTest, PictureIsThatOfTheEditedScene) {
  RenderOptions options = optionsOf(GetParam());
  for (const Edit& edit : edits()) {
    SCOPED_TRACE(edit.name);
    Scene scene = wobblyBall();
    const std::vector<Image> before = render(scene, options, asked());
    edit.edit(scene);
    edit.take(renderer(), scene);
    options.reuseLight = true;
    const std::vector<Image> edited = render(options, asked());
    options.reuseLight = false;
    EXPECT_NE(edited[0].rgba, before[0].rgba);
    expectSame(edited, render(scene, options, asked()));
  }
}

TEST_P(EditTest, AnotherEnvironmentOfTheSameSizeIsSeen) {
  RenderOptions options = optionsOf(GetParam());
  Scene scene = wobblyBall();
  scene.lighting.environment = std::make_shared<const Image>(gradient());
  const std::vector<Image> before = render(scene, options, asked());
  Image other = gradient();
  std::reverse(other.rgba.begin(), other.rgba.end());
  scene.lighting.environment = std::make_shared<const Image>(other);
  takeLighting(renderer(), scene);
  const std::vector<Image> edited = render(options, asked());
  EXPECT_NE(edited[0].rgba, before[0].rgba);
  expectSame(edited, render(scene, options, asked()));
}

// A point light casts as many shadow maps as six directional ones.
TEST_P(EditTest, MoreLightsWithAsManyShadowMapsAreSeen) {
  const RenderOptions options = optionsOf(GetParam());
  Scene scene = wobblyBall();
  scene.lighting.directional.clear();
  scene.lighting.points = {{{30, 20, 10}, {500, 400, 300}}};
  render(scene, options, asked());
  scene.lighting.points.clear();
  for (const float x : {-1.0F, -0.6F, -0.2F, 0.2F, 0.6F, 1.0F})
    scene.lighting.directional.push_back({{x, 0.5F, 1}, {1, 1 + x, 1}});
  takeLighting(renderer(), scene);
  const std::vector<Image> edited = render(options, asked());
  expectSame(edited, render(scene, options, asked()));
}

// Light from before is used, and is right, while only the camera moves.
TEST_P(EditTest, ReusedLightIsTheSameLight) {
  RenderOptions options = optionsOf(GetParam());
  Scene scene = wobblyBall();
  render(scene, options, asked());
  options.reuseLight = true;
  scene.camera.positionMm[1] += 5;
  renderer().setCamera(scene.camera);
  const RenderResult again = renderer().render(options, asked());
  for (const PassTime& pass : again.report.passes) {
    EXPECT_NE(pass.name, "shadow");
    EXPECT_NE(pass.name, "deform");
    EXPECT_NE(pass.name, "solve");
  }
  expectSame(again.images, render(scene, optionsOf(GetParam()), asked()));
}

// What shows no light waits for none, is the same beside a picture, and does not pass for one.
TEST_P(EditTest, VariablesWithoutLightFindNone) {
  RenderOptions options = optionsOf(GetParam());
  options.reuseLight = true;
  const std::vector<Aov> plain{Aov::Position, Aov::Depth, Aov::DsmArea};
  const auto plainAndLit = [&] {
    std::vector<Aov> all = plain;
    all.push_back(Aov::Radiance);
    return all;
  }();
  Scene scene = wobblyBall();
  scene.deformers.push_back({DeformerKind::Wobble, 0.1F, 1});
  renderer().setScene(scene);
  options.seconds = 0.3;
  const std::vector<Image> lit = render(options, plainAndLit);
  options.seconds = 0.1;
  EXPECT_NE(render(options, plain)[0].rgba, lit[0].rgba);
  options.seconds = 0.3;
  const RenderResult alone = renderer().render(options, plain);
  for (const PassTime& pass : alone.report.passes) {
    EXPECT_NE(pass.name, "solve");
    EXPECT_NE(pass.name, "scatter");
    EXPECT_NE(pass.name, "tree");
  }
  EXPECT_TRUE(alone.report.solutions.empty());
  expectSame(alone.images, {lit.begin(), lit.end() - 1});
  expectSame(render(options, plainAndLit), lit);
}

// Two methods that take turns, as on the two sides of a divider, at times that differ.
TEST_P(EditTest, MethodsTakeTurns) {
  const RenderOptions paper = optionsOf(methods[2]);
  const RenderOptions own = optionsOf(GetParam());
  Scene scene = wobblyBall();
  scene.deformers.push_back({DeformerKind::Wobble, 0.1F, 1});
  renderer().setScene(scene);
  const auto at = [](RenderOptions options, double seconds, bool reuse) {
    options.seconds = seconds;
    options.reuseLight = reuse;
    return options;
  };
  const std::vector<Image> first = render(at(own, 0, false), asked());
  const std::vector<Image> other = render(at(paper, 0.3, false), asked());
  expectSame(render(at(own, 0, true), asked()), first);
  expectSame(render(at(paper, 0.3, true), asked()), other);
  expectSame(render(at(paper, 0.3, true), asked()), other);
  expectSame(render(at(own, 0, true), asked()), first);
}

INSTANTIATE_TEST_SUITE_P(Methods, EditTest, testing::ValuesIn(methods),
                         [](const auto& method) { return std::string(method.param.name); });

// Pictures come at once, of the old division, and then the new one's.
TEST_P(EditTest, ImpatientPicturesBecomeTheSame) {
  RenderOptions options = optionsOf(GetParam());
  Scene scene = wobblyBall();
  render(scene, options, asked());
  scene.objects[0].medium.sigmaSPrimePerMm = {9, 8, 7};
  takeMedium(renderer(), scene);
  options.patient = false;
  Frame frame;
  do {
    renderer().submit(options, asked());
    renderer().collect(frame);
  } while (frame.provisional);
  options.patient = true;
  expectSame(frame.images, render(scene, options, asked()));
}

class EditErrorsTest : public RendererTest {};

TEST_F(EditErrorsTest, RefusedEditsChangeNothing) {
  const RenderOptions options = smallOptions();
  const Scene scene = wobblyBall();
  const std::vector<Image> before = render(scene, options, asked());
  Camera camera = scene.camera;
  camera.targetMm = camera.positionMm;
  EXPECT_THROW(renderer().setCamera(camera), Error);
  Lighting lighting = scene.lighting;
  lighting.ambient = {-1, 0, 0};
  EXPECT_THROW(renderer().setLighting(lighting), Error);
  Medium medium = scene.objects[0].medium;
  medium.sigmaSPrimePerMm[1] = 0;
  EXPECT_THROW(renderer().setMedium(0, medium), Error);
  EXPECT_THROW(renderer().setMedium(1, scene.objects[0].medium), UsageError);
  EXPECT_THROW(renderer().setDeformers(std::vector<Deformer>(9)), UsageError);
  expectSame(render(options, asked()), before);
}

TEST_F(EditErrorsTest, EveryMethodKeepsItsPicture) {
  renderer().setScene(wobblyBall());
  Frame frame;
  std::vector<VkImage> images;
  for (const Sum sum : {Sum::Tree, Sum::Pattern, Sum::Tree}) {
    RenderOptions options = smallOptions();
    options.sum = sum;
    renderer().submitOnDevice(options);  // makes what is missing
    renderer().collect(frame);
  }
  for (const Sum sum : {Sum::Tree, Sum::Pattern}) {
    RenderOptions options = smallOptions();
    options.sum = sum;
    images.push_back(renderer().submitOnDevice(options).image);
    renderer().collect(frame);
  }
  EXPECT_NE(images[0], images[1]);
}

// While what others need of the scene is made, or another scene is set, that picture stays.
TEST_F(EditErrorsTest, PictureStaysUntilAThirdKindOfFrame) {
  const auto submit = [&](const Method& method) {
    const DeviceImage image = renderer().submitOnDevice(optionsOf(method));
    Frame frame;
    renderer().collect(frame);
    return image.image;
  };
  // The validation layer complains of images that are gone.
  const auto touch = [&](VkImage image) {
    VkMemoryRequirements requirements{};
    vkGetImageMemoryRequirements(renderer().vulkanDevice().device, image, &requirements);
    EXPECT_GT(requirements.size, 0U);
  };
  renderer().setScene(wobblyBall());
  const VkImage tree = submit(methods[1]);
  const VkImage paper = submit(methods[2]);  // needs a map
  touch(tree);
  EXPECT_NE(paper, tree);
  EXPECT_EQ(submit(methods[1]), tree);
  renderer().setScene(wobblyBall());
  touch(tree);
  touch(paper);
  EXPECT_EQ(submit(methods[2]), paper);
  const VkImage boundary = submit(methods[0]);  // needs clusters
  touch(paper);
  EXPECT_NE(boundary, paper);
}

TEST_F(EditErrorsTest, PictureStaysOnTheDevice) {
  RenderOptions options = smallOptions();
  options.width = 40;
  renderer().setScene(wobblyBall());
  const DeviceImage image = renderer().submitOnDevice(options, {Aov::Exitance});
  EXPECT_NE(image.view, VK_NULL_HANDLE);
  EXPECT_EQ(image.extent.width, 40U);
  EXPECT_EQ(image.extent.height, 64U);
  EXPECT_EQ(image.layout, VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL);
  Frame frame;
  renderer().collect(frame);
  ASSERT_EQ(frame.images.size(), 1U);
  expectSame(frame.images, render(options, {Aov::Exitance}));
}

}  // namespace
}  // namespace opaline::test
