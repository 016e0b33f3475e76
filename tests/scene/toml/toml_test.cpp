#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "opaline/error.h"
#include "opaline/image_file.h"
#include "opaline/media.h"
#include "opaline/scene.h"
#include "opaline/scene_file.h"
#include "scene/shapes.h"
#include "scene/toml/toml_fixture.h"

namespace opaline {
namespace {

using testing::HasSubstr;

TEST_F(Toml, EverythingThatCanBeSaid) {
  writeExr(folder / "sky.exr", [] {
    Image sky(4, 2);
    for (float& value : sky.rgba) value = 0.5F;
    sky.pixel(1, 0)[0] = 3;
    return sky;
  }());
  const LoadedScene loaded = load(model + R"(
[media.soap]
sigma_s_per_mm = [1, 2, 3.5]
sigma_a_per_mm = [0.1, 0.2, 0.3]
eta = 1.4
[media.veined]
measured = "Marble"
eta = 1.6
g = 0.7
[objects.cube]
medium = "soap"
translation_mm = [0, 0, 100]
[[lights]]
type = "directional"
direction_to_light = [0, 0, -2]
irradiance = 3
[[lights]]
type = "point"
position_mm = [0, 20, 0]
intensity = [1, 2, 3]
[[lights]]
type = "spot"
position_mm = [0, 0, 30]
direction = [0, 0, -3]
intensity = 5
outer_degrees = 60
[[lights]]
type = "ambient"
radiance = 0.25
[environment]
file = "sky.exr"
intensity = 4
rotation_degrees = 90
[camera]
position_mm = [0, 0, 50]
target_mm = [0, 5, 0]
up = [0, 0.5, 2]
fov_degrees = 45
[render]
size = [640, 480]
transport = "better-dipole"
sum = "all"
site = "vertex"
tolerance = 0.02
max_surfels = 5000
max_clusters = 6000
ambient_occlusion = true
dsm_size = 256
shadow_size = 2048
specular = false
antialias = 8
exposure = -1.5
tone = "none"
background = [0, 0.25, 1]
device = "llvmpipe"
)");
  const Scene& scene = loaded.scene;
  test::expectSound(scene);
  EXPECT_EQ(scene.objects[0].medium.name, "soap");
  EXPECT_EQ(scene.objects[0].medium.sigmaSPrimePerMm[2], 3.5);
  EXPECT_EQ(scene.objects[0].medium.eta, 1.4);
  const Bounds bounds = boundsOf(scene);
  EXPECT_NEAR(bounds.minMm[0], 10, 1e-4);
  EXPECT_NEAR(bounds.minMm[2], 100, 1e-4);
  EXPECT_NEAR(bounds.maxMm[2], 110, 1e-4);
  ASSERT_EQ(scene.lighting.directional.size(), 1U);
  EXPECT_EQ(scene.lighting.directional[0].directionToLight, (Vec3{0, 0, -1}));
  EXPECT_EQ(scene.lighting.directional[0].irradiance, (Rgb{3, 3, 3}));
  ASSERT_EQ(scene.lighting.points.size(), 1U);
  EXPECT_NEAR(scene.lighting.points[0].positionMm[0], 15, 1e-4);  // relative to the box's centre
  EXPECT_NEAR(scene.lighting.points[0].positionMm[1], 25, 1e-4);
  ASSERT_EQ(scene.lighting.spots.size(), 1U);
  EXPECT_NEAR(scene.lighting.spots[0].positionMm[2], 135, 1e-4);
  EXPECT_EQ(scene.lighting.spots[0].direction, (Vec3{0, 0, -1}));
  EXPECT_EQ(scene.lighting.spots[0].intensity, (Rgb{5, 5, 5}));
  EXPECT_EQ(scene.lighting.spots[0].innerDegrees, 0);
  EXPECT_EQ(scene.lighting.spots[0].outerDegrees, 60);
  EXPECT_EQ(scene.lighting.ambient[1], 0.25F);
  ASSERT_TRUE(scene.lighting.environment);
  EXPECT_FLOAT_EQ(scene.lighting.environment->pixel(0, 0)[0], 12);  // a quarter to the left
  EXPECT_FLOAT_EQ(scene.lighting.environment->pixel(1, 0)[0], 2);
  EXPECT_NEAR(scene.camera.positionMm[2], 155, 1e-4);
  EXPECT_NEAR(scene.camera.targetMm[1], 10, 1e-4);
  EXPECT_EQ(scene.camera.verticalFovDegrees, 45);
  EXPECT_EQ(scene.camera.up, (Vec3{0, 0.5F, 2}));
  options::PictureSettings picture;
  loaded.settings.picture.applyTo(picture);
  const auto& [render, time, tone] = picture;
  EXPECT_EQ(render.width, 640);
  EXPECT_EQ(render.height, 480);
  EXPECT_EQ(render.transport, Transport::BetterDipole);
  EXPECT_EQ(render.sum, Sum::All);
  EXPECT_EQ(render.site, Site::Vertex);
  EXPECT_EQ(render.tolerance, 0.02F);
  EXPECT_EQ(render.maxSurfels, 5000);
  EXPECT_EQ(render.maxClusters, 6000);
  EXPECT_EQ(render.ambientOcclusion, true);
  EXPECT_EQ(render.dsmSize, 256);
  EXPECT_EQ(render.shadowSize, 2048);
  EXPECT_EQ(render.specular, false);
  EXPECT_EQ(render.antialias, 8);
  EXPECT_EQ(tone.exposureStops, -1.5F);
  EXPECT_EQ(tone.curve, ToneCurve::None);
  EXPECT_EQ(tone.background, (Rgb{0, 0.25F, 1}));
  EXPECT_EQ(loaded.settings.named.device, "llvmpipe");
}

TEST_F(Toml, WhatShapesAMethodStandsBesideIt) {
  const auto settings = [&](const std::string& said) {
    options::PictureSettings found;
    load(model + "[render]\n" + said).settings.picture.applyTo(found);
    return found.render;
  };
  const RenderOptions boundary =
      settings("bounces = 5\nroughness = 0.5\nsum = 'all'\ntolerance = 1");
  EXPECT_EQ(boundary.bounces, 5);
  EXPECT_EQ(boundary.roughness, 0.5F);
  EXPECT_EQ(boundary.tolerance, 1);
  const PatternOptions pattern =
      settings("sum = 'pattern'\nnear_rings = 3\nnear_spacing = 0.5\nfar_distance = 20").pattern;
  EXPECT_EQ(pattern.nearRings, 3);
  EXPECT_EQ(pattern.nearSpacing, 0.5F);
  EXPECT_EQ(pattern.farDistance, 20);
}

TEST_F(Toml, WhatNothingReadsIsRefusedUnlessItIsTheDefault) {
  const auto with = [&](const std::string& said) { return errorOf(model + "[render]\n" + said); };
  EXPECT_THAT(
      with("transport = 'dipole'\nbounces = 3"),
      HasSubstr("line 5: 'bounces' in [render] counts how often light enters again and needs "
                "transport = \"boundary\""));
  EXPECT_THAT(with("transport = 'boundary'\nsum = 'pattern'"),
              HasSubstr("line 5: 'sum' in [render] has no surfels for boundary transport and needs "
                        "transport = \"dipole\" or transport = \"better-dipole\""));
  EXPECT_THAT(with("specular = false\nroughness = 0.3"),
              HasSubstr("'roughness' in [render] is of the reflection, which specular = false"));
  EXPECT_THAT(with("near_rings = 3"), HasSubstr("needs sum = \"pattern\""));
  EXPECT_THAT(with("ambient_occlusion = true"), HasSubstr("'ambient_occlusion' in [render] hides"));
  EXPECT_THAT(with("sum = 'all'\ntransport = 'dipole'\ntolerance = 1"),
              HasSubstr("'tolerance' in [render]"));
  EXPECT_THAT(with("sum = 'pattern'\nboundary_surfels = 100"),
              HasSubstr("line 5: 'boundary_surfels' in [render] limits clusters"));
  load(model +
       "[render]\ntransport = 'dipole'\nbounces = 2\nspecular = false\nroughness = 0.25\n"
       "near_rings = 4\nambient_occlusion = false");
}

TEST_F(Toml, DeformersAreAppliedInTheirOrder) {
  const LoadedScene loaded = load(model + R"(
[[deform]]
kind = "squash"
amount = -2
[[deform]]
kind = "wobble"
amount = 0.25
period_seconds = 3
[render]
seconds = 1.5
)");
  ASSERT_EQ(loaded.scene.deformers.size(), 2U);
  EXPECT_EQ(loaded.scene.deformers[0].kind, DeformerKind::Squash);
  EXPECT_EQ(loaded.scene.deformers[0].amount, -2);
  EXPECT_EQ(loaded.scene.deformers[0].periodSeconds, 0);
  EXPECT_EQ(loaded.scene.deformers[1].kind, DeformerKind::Wobble);
  EXPECT_EQ(loaded.scene.deformers[1].amount, 0.25F);
  EXPECT_EQ(loaded.scene.deformers[1].periodSeconds, 3);
  EXPECT_EQ(*loaded.settings.picture.find("seconds"), options::Value(1.5));
  EXPECT_FALSE(loaded.settings.named.clip);
}

TEST_F(Toml, DeformersThatMakeNoSenseAreErrors) {
  const auto with = [&](const std::string& text) { return errorOf(model + "[[deform]]\n" + text); };
  EXPECT_THAT(with("kind = 'swirl'\namount = 1"), HasSubstr("wobble"));
  EXPECT_THAT(with("amount = 1"), HasSubstr("has no 'kind'"));
  EXPECT_THAT(with("kind = 'twist'"), HasSubstr("has no 'amount'"));
  EXPECT_THAT(with("kind = 'bend'\namount = 7"), HasSubstr("from -6.28 to 6.28"));
  EXPECT_THAT(with("kind = 'squash'\namount = -2\nperiod_seconds = 1"),
              HasSubstr("from -0.9 to 0.9"));
  EXPECT_THAT(with("kind = 'twist'\namount = 1\nperiod_seconds = -1"), HasSubstr("period_seconds"));
  EXPECT_THAT(with("kind = 'twist'\namount = 1\nperiod_seconds = 1e-6"), HasSubstr("0.001"));
  EXPECT_THAT(with("kind = 'twist'\namount = 1\nperiod = 1"), HasSubstr("period_seconds"));
}

TEST_F(Toml, MorphsAreReadBesideTheScene) {
  test::writeBytes(folder / "other.ply", test::readBytes(folder / "cube.ply"));
  const LoadedScene loaded = load(model + R"(
morph_to = "other.ply"
[objects.cube]
translation_mm = [0, 0, 100]
scale = 2
[render]
clip = "morph"
)");
  test::expectSound(loaded.scene);
  EXPECT_EQ(loaded.settings.named.clip, "morph");
  const Rig& rig = *loaded.scene.objects[0].rig;
  // A unit is 10 mm, and the placement doubles it.
  EXPECT_NEAR(rig.toScene.columns[0][0], 20, 1e-4);
  EXPECT_NEAR(rig.toScene.columns[3][2], 100, 1e-4);
  EXPECT_THAT(errorOf(model + "morph_to = 'other.ply'\n[render]\nclip = 'murph'"),
              HasSubstr("'morph'"));
  EXPECT_THAT(errorOf(model + "[render]\nclip = 'morph'"), HasSubstr("has none"));
  EXPECT_EQ(load(model + "[render]\nclip = 'none'").settings.named.clip, "none");
  EXPECT_THAT(errorOf(model + "[render]\nseconds = -1"), HasSubstr("seconds"));
  EXPECT_THAT(errorOf("model = 'builtin:teapot'\nmorph_to = 'other.ply'"),
              HasSubstr("line 2: 'morph_to'"));
  EXPECT_THAT(errorOf("model = ''"), HasSubstr("'model' in the scene must not be empty"));
}

TEST_F(Toml, DefaultsStayWhereNothingIsSaid) {
  const LoadedScene loaded = load("model = 'cube.ply'\nmedium = 'ketchup'\n");
  EXPECT_EQ(loaded.scene.lighting.directional.size(), defaultLighting().directional.size());
  EXPECT_NEAR(diagonalMm(loaded.scene), 50, 1e-3);
  EXPECT_EQ(loaded.scene.objects[0].medium.name, "ketchup");
  EXPECT_TRUE(loaded.settings.picture.empty());
  EXPECT_EQ(loadScene(folder / "a.toml").objects.size(), 1U);
}

TEST_F(Toml, SizeAsTextOrList) {
  for (const char* size : {"'640x480'", "[640, 480]"}) {
    const auto settings =
        load(std::string("model = 'cube.ply'\n[render]\nsize = ") + size + "\n").settings;
    EXPECT_EQ(*settings.picture.find("size"), options::Value(options::Size{640, 480}));
  }
}

TEST_F(Toml, TheBearBringsItsCamera) {
  const auto distanceDiagonals = [](const Scene& scene) {
    const Vec3& from = scene.camera.positionMm;
    const Vec3& to = scene.camera.targetMm;
    return std::hypot(from[0] - to[0], from[1] - to[1], from[2] - to[2]) / diagonalMm(scene);
  };
  EXPECT_NEAR(distanceDiagonals(builtInBear()), 1.8, 1e-5);
  EXPECT_NEAR(distanceDiagonals(builtInTeapot()), 1.4, 1e-5);
  const std::string bear = "model = 'builtin:bear'\ndiagonal_mm = 80\n";
  const Scene plain = load(bear).scene;
  EXPECT_NEAR(distanceDiagonals(plain), 1.8, 1e-5);
  EXPECT_GT(plain.camera.positionMm[2], 80);
  const Scene turned = load(bear + "[camera]\ndirection = [-2, 0, 0]\n").scene;
  EXPECT_NEAR(distanceDiagonals(turned), 1.8, 1e-5);
  EXPECT_LT(turned.camera.positionMm[0], -80);
  const Scene aimed = load(bear + "[camera]\ntarget_mm = [5, 0, 0]\n").scene;
  EXPECT_EQ(aimed.camera.positionMm, plain.camera.positionMm);
  const Scene placed = load(bear + "[camera]\nposition_mm = [90, 0, 90]\n").scene;
  EXPECT_EQ(placed.camera.targetMm, plain.camera.targetMm);
  const Scene moved = load(bear + "[objects.bear]\ntranslation_mm = [500, 0, 0]\n").scene;
  EXPECT_NEAR(distanceDiagonals(moved), 1.8, 1e-5);
  EXPECT_NEAR(moved.camera.targetMm[0], 500 + plain.camera.targetMm[0], 1e-2);
}

TEST_F(Toml, BuiltInModels) {
  const Scene teapot = load("model = 'builtin:teapot'\ndiagonal_mm = 80\n").scene;
  EXPECT_EQ(teapot.objects[0].mesh.triangles.size(), 2256U);
  EXPECT_NEAR(diagonalMm(teapot), 80, 1e-3);
  EXPECT_THAT(errorOf("model = 'builtin:dragon'\n"), HasSubstr("builtin:bear"));
}

TEST_F(Toml, ADiagonalFromOutsideScalesLightsAndCameraToo) {
  LoadOptions options;
  options.diagonalMm = 2 * 17.3205081F;
  const std::string text =
      model +
      "[[lights]]\ntype = 'point'\nposition_mm = [-15, -5, 15]\n"
      "intensity = 10\n"
      "[[lights]]\ntype = 'spot'\nposition_mm = [-15, -5, 15]\n"
      "direction = [0, 0, -1]\nintensity = 3\n[camera]\nposition_mm = [0, 0, 50]\n";
  const Scene scene = load(text, options).scene;
  EXPECT_NEAR(diagonalMm(scene), *options.diagonalMm, 1e-3);
  EXPECT_NEAR(scene.lighting.points[0].positionMm[2], 40, 1e-3);
  EXPECT_NEAR(scene.lighting.points[0].intensity[0], 40, 1e-3);
  EXPECT_NEAR(scene.lighting.spots[0].positionMm[2], 40, 1e-3);
  EXPECT_NEAR(scene.lighting.spots[0].intensity[0], 12, 1e-3);
  EXPECT_NEAR(scene.camera.positionMm[2], 110, 1e-3);
}

TEST_F(Toml, TransformsAreRowMajorAndMirrorsKeepTheOutside) {
  const Scene mirrored =
      load(model + "[objects.cube]\ntransform = [-1,0,0,5, 0,2,0,0, 0,0,1,0, 0,0,0,1]\n").scene;
  const Mesh& mesh = mirrored.objects[0].mesh;
  test::expectSound(mirrored);
  EXPECT_NEAR(boundsOf(mirrored).maxMm[0], -5, 1e-3);
  EXPECT_NEAR(boundsOf(mirrored).maxMm[1], 20, 1e-3);
  EXPECT_NEAR(test::signedVolume(mesh.positionsMm, mesh.triangles), 2000, 0.1);
  const Scene turned =
      load(model + "[objects.cube]\nrotation_degrees = [0, 0, 90]\nscale = 2\n").scene;
  EXPECT_NEAR(boundsOf(turned).minMm[1], 20, 1e-3);  // +x became +y
  EXPECT_NEAR(boundsOf(turned).minMm[0], -20, 1e-3);
}

TEST_F(Toml, UnknownKeysNameTheNearest) {
  EXPECT_THAT(errorOf("modle = 'cube.ply'\n"), AllOf(HasSubstr("'modle'"), HasSubstr("'model'")));
  EXPECT_THAT(errorOf(model + "[camera]\nfov = 30\n"),
              AllOf(HasSubstr("line 4"), HasSubstr("'fov_degrees'")));
  EXPECT_THAT(errorOf(model + "[render]\nexposrue = 1\n"), HasSubstr("'exposure'"));
  EXPECT_THAT(errorOf(model + "[objects.cub]\n"), HasSubstr("'cube'"));
  EXPECT_THAT(errorOf(model + "[[lights]]\ntype='point'\nposition_mm=[0,0,0]\nirradiance=1\n"),
              HasSubstr("'irradiance'"));
}

TEST_F(Toml, WrongValuesNameKeyAndLine) {
  const std::pair<const char*, const char*> cases[] = {
      {"model = 5\n", "'model'"},
      {"diagonal_mm = 5\n", "'model'"},
      {"model = 'cube.ply'\ndiagonal_mm = -1\n", "line 2"},
      {"model = 'cube.ply'\ndiagonal_mm = nan\n", "'diagonal_mm'"},
      {"model = 'cube.ply'\n[render]\nsize = [0, 5]\n", "'size'"},
      {"model = 'cube.ply'\n[render]\nsize = '0x5'\n", "'size'"},
      {"model = 'cube.ply'\n[render]\nsize = '5'\n", "WIDTHxHEIGHT"},
      {"model = 'cube.ply'\n[render]\nsize = '5x5x5'\n", "WIDTHxHEIGHT"},
      {"model = 'cube.ply'\n[render]\nsize = '99999999999x5'\n", "WIDTHxHEIGHT"},
      {"model = 'cube.ply'\n[render]\nsize = [2.5, 5]\n", "WIDTHxHEIGHT"},
      {"model = 'cube.ply'\n[render]\nantialias = 3\n", "1, 2, 4 or 8"},
      {"model = 'cube.ply'\n[render]\nspecular = 1\n", "true or false"},
      {"model = 'cube.ply'\n[render]\ndsm_size = 99999999999999999\n", "from 64 to 4096"},
      {"model = 'cube.ply'\n[render]\nsite = 'pixel'\n", "fragment"},
      {"model = 'cube.ply'\n[media.a]\nmeasured = 'lava'\n", "'measured'"},
      {"model = 'cube.ply'\n[media.a]\neta = 1.3\n", "sigma_s_per_mm"},
      {"model = 'cube.ply'\n[media.a]\nsigma_s_per_mm=[1,1,1]\nsigma_a_per_mm=[-1,1,1]\n",
       "sigma_a_per_mm"},
      {"model = 'cube.ply'\nmedia = 3\n", "table"},
      {"model = 'cube.ply'\n[objects.cube]\nmedium = 'x'\n", "'x'"},
      {"model = 'cube.ply'\n[objects.cube]\ntransform = [1,2]\n", "16"},
      {"model = 'cube.ply'\n[objects.cube]\ntransform = [0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1]\n",
       "flattens"},
      {"model = 'cube.ply'\n[[lights]]\nirradiance = 1\n", "'type'"},
      {"model = 'cube.ply'\nlights = 5\n", "[[lights]]"},
      {"model = 'cube.ply'\n[[lights]]\ntype = 'directional'\ndirection_to_light = [0,0,0]\n",
       "zero"},
      {"model = 'cube.ply'\n[camera]\nposition_mm = [0,0,0]\n", "same position"},
      {"model = 'cube.ply'\n[camera]\nfov_degrees = 0\n", "from 1 to 170"},
      {"model = 'cube.ply'\n[camera]\nup = [0, 0, 0]\n", "'up'"},
      {"model = 'cube.ply'\n[render]\nbackground = [0, 2, 0]\n", "'background'"},
      {"model = 'cube.ply\n", "line 1"},
      {"model = '\xFF'\n", "line 1"},
      {"model = 'a.toml'\n", "another .toml"},
  };
  for (const auto& [text, part] : cases) {
    EXPECT_THAT(errorOf(text), HasSubstr(part)) << text;
  }
  EXPECT_THAT(errorOf("model = " + std::string(100000, '[')), HasSubstr("deep"));
}

TEST_F(Toml, AnUnknownNameIsToldANearOneOrThoseThereAre) {
  EXPECT_THAT(errorOf("model = 'cube.ply'\ndiagonal = 3\n"),
              HasSubstr("not a known key; the nearest is 'diagonal_mm'"));
  EXPECT_THAT(errorOf("model = 'cube.ply'\n[ground]\nresolution = 3\n"),
              testing::EndsWith("is not a known key; there are 'color' and 'height_mm'"));
  EXPECT_THAT(errorOf("model = 'cube.ply'\n[objects.cubo]\n"), HasSubstr("the nearest is 'cube'"));
  EXPECT_THAT(errorOf("model = 'cube.ply'\n[objects.teapot]\n"), HasSubstr("there is only 'cube'"));
}

TEST_F(Toml, AnUpAlongTheViewIsNoted) {
  std::vector<std::string> notes;
  LoadOptions options;
  options.diagonalMm = 50;
  options.log = [&](LogLevel, std::string_view message) { notes.emplace_back(message); };
  const std::string camera = "model = 'cube.ply'\n[camera]\ndirection = [0, 0, 1]\nup = ";
  load(camera + "[0, 0.01, 1]\n", options);
  EXPECT_THAT(notes, testing::IsEmpty());
  for (const std::string along : {"[0, 0, 1]", "[0, 0, -5]"}) {
    notes.clear();
    load(camera + along + "\n", options);
    EXPECT_THAT(notes, testing::ElementsAre(HasSubstr("'up' in [camera] is parallel to the view")));
  }
}

TEST_F(Toml, AFieldOfViewOfParallelLinesOfSightIsNoted) {
  std::vector<std::string> notes;
  LoadOptions options;
  options.diagonalMm = 50;
  options.log = [&](LogLevel, std::string_view message) { notes.emplace_back(message); };
  const std::string camera = "model = 'cube.ply'\n[camera]\n";
  const LoadedScene parallel = load(camera + "orthographic_height_mm = 40\n", options);
  load(camera + "fov_degrees = 45\n", options);
  EXPECT_THAT(notes, testing::IsEmpty());
  load(camera + "orthographic_height_mm = 40\nfov_degrees = 45\n", options);
  EXPECT_THAT(notes, testing::ElementsAre(HasSubstr("'fov_degrees' in [camera] is not used")));
  notes.clear();
  // What is written of such a camera draws no note.
  const std::filesystem::path file = folder / "written.toml";
  writeScene({file, Existing::Replace}, describe(parallel.scene, parallel.source, {}));
  EXPECT_EQ(loadSceneFile(file, options).scene.camera, parallel.scene.camera);
  EXPECT_THAT(notes, testing::IsEmpty());
}

TEST_F(Toml, MediaAreReadWithoutTheModel) {
  const std::filesystem::path file = folder / "a.toml";
  test::writeBytes(file,
                   "model = 'none.ply'\n[media.jelly]\nsigma_s_per_mm = 3\n"
                   "sigma_a_per_mm = [1, 0.5, 0.25]\n[media.'red sauce']\nmeasured = 'ketchup'\n");
  const auto media = mediaOf(file);
  ASSERT_EQ(media.size(), 2U);
  EXPECT_EQ(media.at("jelly").sigmaSPrimePerMm[2], 3);
  EXPECT_EQ(media.at("jelly").sigmaAPerMm[2], 0.25);
  EXPECT_EQ(media.at("red sauce").sigmaSPrimePerMm, findMedium("ketchup")->sigmaSPrimePerMm);
  EXPECT_TRUE(mediaOf(folder / "cube.ply").empty());
  test::writeBytes(file, "[media.jelly]\neta = 1.3\n");
  EXPECT_THAT(test::messageOf([&] { mediaOf(file); }), HasSubstr("a.toml"));
}

TEST_F(Toml, AMissingModelIsNamed) {
  EXPECT_THAT(test::messageOf([&] { load("model = 'none.obj'\n"); }), HasSubstr("none.obj"));
}

}  // namespace
}  // namespace opaline
