#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "renderer/renderer_fixture.h"
#include "renderer/wobbly_ball.h"

namespace opaline::test {
namespace {

// Edits, applied both to a scene and to a renderer that shows it.
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
void takeMaterial(Renderer& renderer, const Scene& scene) {
  renderer.setMaterial(0, materialOf(scene.objects[0]));
}
void takeDeformers(Renderer& renderer, const Scene& scene) {
  renderer.setDeformers(scene.deformers);
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
      {"roughness", [](Scene& s) { s.objects[0].surface = TranslucentSurface{.roughness = 0.6F}; },
       takeMaterial},
      {"deformer", [](Scene& s) { s.deformers[0].amount = -1; }, takeDeformers},
      {"another deformer",
       [](Scene& s) {
         s.deformers.push_back({DeformerKind::Bend, 0.5F, 0});
       },
       takeDeformers},
  };
  return list;
}

class EditTest : public RendererTestBase<testing::TestWithParam<Method>> {};

// The result must equal that of the edited scene bit by bit, whatever was shown before.
TEST_P(EditTest, PictureIsThatOfTheEditedScene) {
  const RenderOptions options = optionsOf(GetParam());
  for (const Edit& edit : edits()) {
    SCOPED_TRACE(edit.name);
    Scene scene = wobblyBall();
    const std::vector<Image> before = render(scene, options, asked());
    View view(renderer(), options);
    view.render({.aovs = asked()});
    edit.edit(scene);
    edit.take(renderer(), scene);
    const std::vector<Image> edited = view.render({.aovs = asked(), .reuseLight = true}).images;
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

// While only the camera moves, earlier light is reused and stays right.
TEST_P(EditTest, ReusedLightIsTheSameLight) {
  Scene scene = wobblyBall();
  renderer().setScene(scene);
  View view(renderer(), optionsOf(GetParam()));
  view.render({.aovs = asked()});
  scene.camera.positionMm[1] += 5;
  renderer().setCamera(scene.camera);
  const RenderResult again = view.render({.aovs = asked(), .reuseLight = true});
  for (const PassTime& pass : again.report.passes) {
    EXPECT_NE(pass.name, "shadow");
    EXPECT_NE(pass.name, "deform");
    EXPECT_NE(pass.name, "solve");
  }
  expectSame(again.images, render(scene, optionsOf(GetParam()), asked()));
}

// A picture of another size and with other samples reuses the light.
TEST_P(EditTest, AnotherSizeKeepsTheLight) {
  const Scene scene = wobblyBall();
  RenderOptions options = optionsOf(GetParam());
  renderer().setScene(scene);
  View view(renderer(), options);
  view.render({});
  options.width *= 2;
  options.height += 7;
  options.antialias = 4;
  view.setOptions(options);
  const RenderResult larger = view.render({.reuseLight = true});
  if (GetParam().sum != Sum::Pattern) {  // whose map depends on the picture's size
    for (const PassTime& pass : larger.report.passes) {
      EXPECT_NE(pass.name, "shadow");
      EXPECT_NE(pass.name, "deform");
      EXPECT_NE(pass.name, "solve");
    }
  }
  expectSame(larger.images, render(scene, options, {Aov::Radiance}));
}

// Variables without light do not wait for it, are the same next to a picture, and do not count as
// one.
TEST_P(EditTest, VariablesWithoutLightFindNone) {
  const std::vector<Aov> plain{Aov::Position, Aov::Depth, Aov::DsmArea};
  const auto plainAndLit = [&] {
    std::vector<Aov> all = plain;
    all.push_back(Aov::Radiance);
    return all;
  }();
  Scene scene = wobblyBall();
  scene.deformers.push_back({DeformerKind::Wobble, 0.1F, 1});
  renderer().setScene(scene);
  View view(renderer(), optionsOf(GetParam()));
  const auto at = [&](double seconds, const std::vector<Aov>& aovs) {
    renderer().setTime({.seconds = seconds});
    return view.render({.aovs = aovs, .reuseLight = true});
  };
  const std::vector<Image> lit = at(0.3, plainAndLit).images;
  EXPECT_NE(at(0.1, plain).images[0].rgba, lit[0].rgba);
  const RenderResult alone = at(0.3, plain);
  for (const PassTime& pass : alone.report.passes) {
    EXPECT_NE(pass.name, "solve");
    EXPECT_NE(pass.name, "scatter");
    EXPECT_NE(pass.name, "tree");
  }
  EXPECT_TRUE(alone.report.solutions.empty());
  expectSame(alone.images, {lit.begin(), lit.end() - 1});
  expectSame(at(0.3, plainAndLit).images, lit);
}

// Two methods take turns, as on both sides of a divider, at different times.
TEST_P(EditTest, MethodsTakeTurns) {
  View paper(renderer(), optionsOf(methods[2]));
  View own(renderer(), optionsOf(GetParam()));
  Scene scene = wobblyBall();
  scene.deformers.push_back({DeformerKind::Wobble, 0.1F, 1});
  renderer().setScene(scene);
  const auto at = [](View& view, double seconds, bool reuse) {
    renderer().setTime({.seconds = seconds});
    return view.render({.aovs = asked(), .reuseLight = reuse}).images;
  };
  const std::vector<Image> first = at(own, 0, false);
  const std::vector<Image> other = at(paper, 0.3, false);
  expectSame(at(own, 0, true), first);
  expectSame(at(paper, 0.3, true), other);
  expectSame(at(paper, 0.3, true), other);
  expectSame(at(own, 0, true), first);
}

INSTANTIATE_TEST_SUITE_P(Methods, EditTest, testing::ValuesIn(methods),
                         [](const auto& method) { return std::string(method.param.name); });

// Pictures come at once with the old division, and then with the new one.
TEST_P(EditTest, ImpatientPicturesBecomeTheSame) {
  const RenderOptions options = optionsOf(GetParam());
  Scene scene = wobblyBall();
  render(scene, options, asked());
  scene.objects[0].medium.sigmaSPrimePerMm = {9, 8, 7};
  takeMedium(renderer(), scene);
  View view(renderer(), options);
  Frame frame;
  do {
    view.submit({.aovs = asked(), .patient = false});
    view.collect(frame);
  } while (frame.provisional);
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
  Material material = materialOf(scene.objects[0]);
  material.surface = TranslucentSurface{.roughness = 2.0F};
  EXPECT_THROW(renderer().setMaterial(0, material), Error);
  material.opaque = mattMaterial({1, 1, 1});
  EXPECT_THROW(renderer().setMaterial(0, material), UsageError);
  expectSame(render(options, asked()), before);
}

}  // namespace
}  // namespace opaline::test
