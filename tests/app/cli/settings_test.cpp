#include <gtest/gtest.h>

#include "cli/motion_options.h"
#include "cli/picture_options.h"

namespace opaline::app {
namespace {

Scene withClips() {
  Scene scene;
  scene.clips = {{"walk", 1, {}}, {"run", 2, {}}};
  return scene;
}

/// As the command line understands a file, where no option is given.
options::PictureSettings understood(const SceneFileSettings& settings, const Scene& scene) {
  RenderOptions options = optionsOf(settings);
  MethodOptions().applyTo(options, settings);
  PictureOptions().applyTo(options);
  return {.render = options, .time = MotionOptions().time(scene, settings)};
}

void expectSame(const options::PictureSettings& found, const options::PictureSettings& wanted) {
  const RenderOptions& a = found.render;
  // As many names as there are options, so that a new one does not compile before it is here.
  const auto& [width, height, transport, sum, site, tolerance, maxSurfels, maxClusters, bounces,
               ambientOcclusion, pattern, dsmSize, shadowSize, specular, roughness, treeLevel,
               antialias, environmentBehind] = wanted.render;
  const auto& [nearRings, nearSpacing, farDistance] = pattern;
  EXPECT_EQ(a.width, width);
  EXPECT_EQ(a.height, height);
  EXPECT_EQ(a.transport, transport);
  EXPECT_EQ(a.sum, sum);
  EXPECT_EQ(a.site, site);
  EXPECT_EQ(a.tolerance, tolerance);
  EXPECT_EQ(a.maxSurfels, maxSurfels);
  EXPECT_EQ(a.maxClusters, maxClusters);
  EXPECT_EQ(a.bounces, bounces);
  EXPECT_EQ(a.ambientOcclusion, ambientOcclusion);
  EXPECT_EQ(a.pattern.nearRings, nearRings);
  EXPECT_EQ(a.pattern.nearSpacing, nearSpacing);
  EXPECT_EQ(a.pattern.farDistance, farDistance);
  EXPECT_EQ(a.dsmSize, dsmSize);
  EXPECT_EQ(a.shadowSize, shadowSize);
  EXPECT_EQ(a.specular, specular);
  EXPECT_EQ(a.roughness, roughness);
  EXPECT_EQ(a.antialias, antialias);
  EXPECT_EQ(a.environmentBehind, environmentBehind);
  EXPECT_EQ(found.time, wanted.time);
  static_cast<void>(treeLevel);  // of a variable, not of the picture
}

TEST(Settings, OptionsComeBack) {
  RenderOptions options;
  options.width = 321;
  options.height = 123;
  options.transport = Transport::BetterDipole;
  options.sum = Sum::All;
  options.site = Site::Vertex;
  options.tolerance = 0.123F;
  options.maxSurfels = 4321;
  options.maxClusters = 777;
  options.ambientOcclusion = true;
  options.bounces = 5;
  options.pattern = {3, 1.5F, 17};
  options.dsmSize = 99;
  options.shadowSize = 101;
  options.specular = false;
  options.roughness = 0.7F;
  options.antialias = 8;
  for (const int clip : {-1, 0, 1}) {
    const options::PictureSettings picture{.render = options, .time = {1.23, clip}};
    expectSame(understood(settingsOf(picture, withClips()), withClips()), picture);
  }
  expectSame(understood(settingsOf({}, {}), {}), {});
  // What the file of the paper's method says is not taken for the pattern alone.
  options.sum = Sum::Pattern;
  const options::PictureSettings paper{.render = options};
  expectSame(understood(settingsOf(paper, withClips()), withClips()), paper);
}

TEST(Settings, ToneComesBack) {
  ToneOptions tone;
  tone.exposureStops = -1.25F;
  tone.curve = ToneCurve::None;
  tone.background = Rgb{0.25F, 0.5F, 1};
  for (const ToneOptions& wanted : {tone, ToneOptions{}}) {
    const SceneFileSettings settings = settingsOf({.tone = wanted}, {});
    for (const ToneOptions& found : {toneOf(settings, {}), PictureOptions().tone(settings, {})}) {
      EXPECT_EQ(found.exposureStops, wanted.exposureStops);
      EXPECT_EQ(found.curve, wanted.curve);
      EXPECT_EQ(found.background, wanted.background);
    }
  }
}

TEST(Settings, ExposureFollowsTheLightUnlessItIsSaid) {
  Scene bright;
  bright.lighting.ambient = {5, 5, 5};  // radiance of white, twice the brightest that is left
  SceneFileSettings settings;
  EXPECT_EQ(toneOf(settings, bright).exposureStops, -1);
  EXPECT_EQ(PictureOptions().noteOnExposure(settings, toneOf(settings, bright)),
            "exposure set to -1 stops to suit the light; --exposure 0 keeps it at 0");
  settings.picture.set(options::fieldOf<options::PictureSettings>("exposure"), 0.0F);
  EXPECT_EQ(toneOf(settings, bright).exposureStops, 0);
  EXPECT_EQ(PictureOptions().noteOnExposure(settings, toneOf(settings, bright)), std::nullopt);
}

}  // namespace
}  // namespace opaline::app
