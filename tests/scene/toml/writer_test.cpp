#include "opaline/scene_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <toml++/toml.h>

#include <memory>
#include <set>
#include <string>

#include "opaline/error.h"
#include "opaline/media.h"
#include "scene/toml/keys.h"
#include "scene/toml/writer_fixture.h"

namespace opaline {
namespace {

using testing::HasSubstr;

/// Restores the current folder at the end.
class CurrentFolder {
 public:
  explicit CurrentFolder(const fs::path& folder) { fs::current_path(folder); }
  ~CurrentFolder() { fs::current_path(before_); }
  CurrentFolder(const CurrentFolder&) = delete;
  CurrentFolder& operator=(const CurrentFolder&) = delete;

 private:
  fs::path before_ = fs::current_path();
};

void expectSameLighting(const Lighting& a, const Lighting& b) {
  EXPECT_TRUE(a.directional == b.directional);
  EXPECT_TRUE(a.points == b.points);
  EXPECT_TRUE(a.spots == b.spots);
  EXPECT_TRUE(a.areas == b.areas);
  EXPECT_EQ(a.ambient, b.ambient);
  ASSERT_EQ(a.environment == nullptr, b.environment == nullptr);
  if (a.environment) {
    EXPECT_EQ(a.environment->rgba, b.environment->rgba);
  }
}

void expectSame(const Scene& a, const Scene& b) {
  ASSERT_EQ(a.objects.size(), b.objects.size());
  for (std::size_t i = 0; i < a.objects.size(); ++i) {
    EXPECT_EQ(a.objects[i].name, b.objects[i].name);
    EXPECT_EQ(a.objects[i].mesh.positionsMm, b.objects[i].mesh.positionsMm);
    EXPECT_EQ(a.objects[i].mesh.normals, b.objects[i].mesh.normals);
    EXPECT_EQ(a.objects[i].mesh.triangles, b.objects[i].mesh.triangles);
    EXPECT_TRUE(a.objects[i].medium == b.objects[i].medium);
  }
  expectSameLighting(a.lighting, b.lighting);
  EXPECT_EQ(a.camera.positionMm, b.camera.positionMm);
  EXPECT_EQ(a.camera.targetMm, b.camera.targetMm);
  EXPECT_EQ(a.camera.up, b.camera.up);
  EXPECT_EQ(a.camera.verticalFovDegrees, b.camera.verticalFovDegrees);
  EXPECT_TRUE(a.deformers == b.deformers);
}

TEST_F(SceneWriter, EverythingComesBackBitByBit) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(seed);
    const LoadedScene loaded = random(seed);
    written(loaded);
    const LoadedScene again = back();
    expectSame(again.scene, loaded.scene);
    EXPECT_EQ(again.settings, loaded.settings);
    if (HasFailure()) FAIL() << test::readBytes(file());
  }
}

TEST_F(SceneWriter, OptionsThatNothingReadsAreLeftOut) {
  LoadedScene loaded = random(1);
  options::PictureSettings picture;
  picture.render.transport = Transport::Dipole;
  picture.render.bounces = 5;
  picture.render.specular = false;
  picture.render.roughness = 0.5F;
  picture.render.tolerance = 0.5F;
  loaded.settings.picture = options::chosenIn(picture);
  written(loaded);
  loaded.settings.picture.erase("bounces");
  loaded.settings.picture.erase("roughness");
  EXPECT_EQ(back().settings, loaded.settings);
}

TEST_F(SceneWriter, AGroundComesBackWithItsColourAndHeight) {
  LoadedScene loaded = random(5);
  loaded.scene.objects.push_back(
      groundUnder(loaded.scene, {.color = {0.25F, 0.5F, 1}, .heightMm = -123.5F}));
  written(loaded);
  const Scene again = back().scene;
  const Object* ground = groundOf(again);
  ASSERT_NE(ground, nullptr);
  EXPECT_EQ(ground->opaque->baseColor, (Rgb{0.25F, 0.5F, 1}));
  EXPECT_NEAR(ground->mesh.positionsMm[0][1], -123.5F, 1e-3F);
  EXPECT_EQ(boundsOf(again).minMm, boundsOf(loaded.scene).minMm);
}

TEST_F(SceneWriter, AGroundLiesUnderTheModelUnlessItsHeightIsGiven) {
  const auto heightOver = [&](const char* keys, const LoadedScene& plain) {
    test::writeBytes(file(), "model = \"../../models/cubes.glb\"\n[ground]\n" + std::string(keys));
    return double{groundOf(back().scene)->mesh.positionsMm[0][1]} -
           double{boundsOf(plain.scene).minMm[1]};
  };
  const LoadedScene plain = loadSceneFile(model());
  EXPECT_EQ(heightOver("", plain), 0);
  const Bounds bounds = boundsOf(plain.scene);
  const double half = 0.5 * double{bounds.maxMm[1] - bounds.minMm[1]};
  EXPECT_NEAR(heightOver("height_mm = -50", plain), half - 50, 1e-3);
  for (const char* bad : {"color = [0.5, 2, 0]", "color = \"red\"", "height = 3"})
    EXPECT_THROW(heightOver(bad, plain), Error) << bad;
}

TEST_F(SceneWriter, WhatIsWrittenTwiceIsTheSame) {
  const std::string first = written(random(7));
  EXPECT_EQ(written(back()), first);
}

TEST_F(SceneWriter, IsFoundFromAnyFolder) {
  const LoadedScene loaded = random(3);
  {
    const CurrentFolder here(folder / "scenes");
    writeScene(fs::path("mine/a.toml"), describe(loaded.scene, loaded.source, loaded.settings));
  }
  const std::string text = test::readBytes(file());
  EXPECT_THAT(text, HasSubstr("model = \"../../models/cubes.glb\""));
  EXPECT_THAT(text, HasSubstr(R"(file = "../../sky \"1\".exr")"));
  const CurrentFolder elsewhere(folder / "models");
  expectSame(loadSceneFile("../scenes/mine/a.toml").scene, loaded.scene);
  // Everything may be moved together.
  fs::create_directory(folder / "moved");
  for (const char* part : {"models", "scenes", "sky \"1\".exr"}) {
    fs::rename(folder / part, folder / "moved" / part);
  }
  expectSame(loadSceneFile(folder / "moved/scenes/mine/a.toml").scene, loaded.scene);
}

TEST_F(SceneWriter, ALinkedFolderIsFollowedAndALinkedModelIsNot) {
  fs::create_directory_symlink(folder / "scenes" / "mine", folder / "shortcut");
  fs::create_symlink("cubes.glb", folder / "models" / "current.glb");
  const LoadedScene loaded = loadSceneFile(folder / "models" / "current.glb");
  writeScene(folder / "shortcut" / "a.toml", describe(loaded.scene, loaded.source, {}));
  EXPECT_THAT(test::readBytes(file()), HasSubstr("\"../../models/current.glb\""));
  expectSame(loadSceneFile(folder / "shortcut" / "a.toml").scene, loaded.scene);
}

TEST_F(SceneWriter, WhatHasOnlyTheRootInCommonStaysAbsolute) {
  LoadedScene loaded = random(1);
  loaded.source.models[0].file = "/elsewhere/far/model.ply";
  EXPECT_THAT(written(loaded), HasSubstr("model = \"/elsewhere/far/model.ply\""));
}

/// Collects all keys of a table and its subtables, as in "lights.type".
void collect(const toml::table& table, const std::string& place, std::set<std::string>& keys) {
  for (const auto& [key, value] : table) {
    const std::string path = place + std::string(key.str());
    keys.insert(path);
    if (const toml::table* inner = value.as_table()) {
      for (const auto& [name, entry] : *inner) {
        // The tables below [media] and [objects] have free names.
        const bool named = entry.is_table();
        if (named) collect(*entry.as_table(), path + ".", keys);
        if (!named) keys.insert(path + "." + std::string(name.str()));
      }
    }
    if (const toml::array* list = value.as_array()) {
      for (const toml::node& entry : *list) {
        if (entry.is_table()) collect(*entry.as_table(), path + ".", keys);
      }
    }
  }
}

// Where users may write something in two ways, the writer uses one.
TEST_F(SceneWriter, WritesEveryKeyThatTheLoaderKnows) {
  std::set<std::string> wanted;
  const auto want = [&](const std::string& place, const auto& keys) {
    for (const std::string_view key : keys) wanted.insert(place + std::string(key));
  };
  want("", scene::keys::root);
  want("models.", scene::keys::model);
  want("media.", scene::keys::medium);
  want("objects.", scene::keys::object);
  want("materials.", scene::keys::material);
  want("deform.", scene::keys::deform);
  want("lights.", scene::keys::directional);
  want("lights.", scene::keys::point);
  want("lights.", scene::keys::spot);
  want("lights.", scene::keys::rectangle);
  want("lights.", scene::keys::disc);
  want("lights.", scene::keys::sphere);
  want("lights.", scene::keys::tube);
  want("lights.", scene::keys::ambient);
  want("environment.", scene::keys::environment);
  want("camera.", scene::keys::camera);
  want("ground.", scene::keys::ground);
  for (const auto& field : options::fieldsOf<options::PictureSettings>())
    wanted.insert("render." + std::string(field.key));
  for (const auto& field : options::fieldsOf<options::NamedSettings>())
    wanted.insert("render." + std::string(field.key));
  for (const char* otherwise : {"media.measured", "camera.direction", "models.medium"})
    wanted.erase(otherwise);

  std::set<std::string> found;
  LoadedScene loaded = random(2);
  loaded.scene.objects.push_back(groundUnder(loaded.scene));
  loaded.source.materials["clay"].isOpaque = true;
  loaded.source.materials["clay"].opaque = options::chosenIn(OpaqueMaterial{});
  for (const char* key :
       {"color_texture", "base_color_texture", "metallic_roughness_texture", "specular_texture",
        "specular_color_texture", "normal_texture", "occlusion_texture", "emission_texture",
        "diffuse_transmission_texture", "diffuse_transmission_color_texture"})
    loaded.source.materials["clay"].textures[key] = model();
  loaded.source.materials["jelly"].appearance = options::chosenIn(Appearance{});
  loaded.source.materials["wax"].medium = "marble";
  loaded.source.colorModel = ColorModel::Khr;
  loaded.scene.camera.orthographicHeightMm = 40.0F;
  loaded.settings.picture = options::chosenIn(
      options::PictureSettings{.render = {}, .time = {}, .tone = {.background = Rgb{}}});
  loaded.scene.objects[2].opaque = OpaqueMaterial{};
  loaded.source.materialOfObject[loaded.scene.objects[2].name] = "clay";
  loaded.source.numbersOfObject[loaded.scene.objects[2].name].opaque =
      options::chosenIn(OpaqueMaterial{});
  loaded.scene.objects[1].paint = Paint{};
  loaded.source.models[0].diagonalMm = 5;
  loaded.source.models[0].morphTo = model();
  loaded.source.placements[names[0]].rows = {{1, 0, 0, 3, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
  loaded.source.placements[names[1]] = {{}, {1, 2, 3}, {4, 5, 6}, 7};
  collect(toml::parse(written(loaded)), "", found);
  for (Object& object : loaded.scene.objects) object.medium = loaded.scene.objects[1].medium;
  loaded.scene.objects[2].opaque.reset();
  loaded.scene.objects[1].paint.reset();
  loaded.source.materialOfObject.clear();
  loaded.scene.camera.orthographicHeightMm.reset();
  collect(toml::parse(written(loaded)), "", found);
  ModelSource& model = loaded.source.models.front();
  model.placement = loaded.source.placements[names[0]];
  loaded.source.models.push_back({model.file, {}, {}, loaded.source.placements[names[1]]});
  collect(toml::parse(written(loaded)), "", found);
  EXPECT_EQ(found, wanted);
}

TEST(SceneKeys, AreAllInTheDocument) {
  const std::string document =
      test::readBytes(fs::path(OPALINE_SOURCE_DIR) / "docs" / "scene-files.md");
  const auto expectAll = [&](const auto& keys) {
    for (const std::string_view key : keys) {
      const std::string word(key);
      EXPECT_THAT(document, testing::AnyOf(HasSubstr("`" + word + "`"), HasSubstr("[" + word + "]"),
                                           HasSubstr("[" + word + ".")));
    }
  };
  expectAll(scene::keys::root);
  expectAll(scene::keys::model);
  expectAll(scene::keys::medium);
  expectAll(scene::keys::object);
  expectAll(scene::keys::material);
  expectAll(scene::keys::deform);
  expectAll(scene::keys::directional);
  expectAll(scene::keys::point);
  expectAll(scene::keys::spot);
  expectAll(scene::keys::rectangle);
  expectAll(scene::keys::disc);
  expectAll(scene::keys::sphere);
  expectAll(scene::keys::tube);
  expectAll(scene::keys::ambient);
  expectAll(scene::keys::environment);
  expectAll(scene::keys::camera);
  expectAll(scene::keys::ground);
  std::vector<std::string_view> fields;
  for (const auto& field : options::fieldsOf<options::PictureSettings>())
    fields.push_back(field.key);
  for (const auto& field : options::fieldsOf<options::NamedSettings>()) fields.push_back(field.key);
  expectAll(fields);
}

TEST_F(SceneWriter, PlacementsComeBack) {
  test::writeBytes(folder / "scenes" / "b.toml", R"(model = "../models/cubes.glb"
diagonal_mm = 33.3
[objects.plain]
translation_mm = [0.1, 20, 1e-7]
rotation_degrees = [10, -20, 33.3]
scale = 1.7
[objects."dots.and\"quotes\"\\'"]
transform = [-1, 0.25, 0, 12.3, 0, 1.1, 0, 0.1, 0, 0, 0.7, 0, 0, 0, 0, 1]
)");
  const LoadedScene loaded = loadSceneFile(folder / "scenes" / "b.toml");
  written(loaded);
  expectSame(back().scene, loaded.scene);
  LoadOptions larger;
  larger.diagonalMm = 500;
  const LoadedScene scaled = loadSceneFile(folder / "scenes" / "b.toml", larger);
  written(scaled);
  const Scene again = back().scene;
  for (std::size_t i = 0; i < again.objects.size(); ++i) {
    const auto& positions = again.objects[i].mesh.positionsMm;
    for (std::size_t v = 0; v < positions.size(); ++v) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(positions[v][axis], scaled.scene.objects[i].mesh.positionsMm[v][axis], 1e-4);
      }
    }
  }
}

TEST_F(SceneWriter, BuiltInModelsOfAnySize) {
  LoadOptions options;
  options.diagonalMm = 71.3F;
  for (const bool teapot : {true, false}) {
    const LoadedScene loaded{teapot ? builtInTeapot(options) : builtInBear(options),
                             {},
                             sourceOf(teapot ? "builtin:teapot" : "builtin:bear", options)};
    EXPECT_THAT(written(loaded),
                HasSubstr(teapot ? "model = \"builtin:teapot\"" : "model = \"builtin:bear\""));
    expectSame(back().scene, loaded.scene);
  }
}

TEST_F(SceneWriter, MorphsComeBack) {
  test::writeBytes(folder / "models" / "one.glb", rowOfCubes({"one"}));
  test::writeBytes(folder / "models" / "other.glb", rowOfCubes({"one"}));
  LoadOptions options;
  options.morphTo = folder / "models" / "other.glb";
  LoadedScene loaded = loadSceneFile(folder / "models" / "one.glb", options);
  loaded.settings.named.clip = "morph";
  EXPECT_THAT(written(loaded), HasSubstr("morph_to = \"../../models/other.glb\""));
  EXPECT_EQ(back().scene.clips.size(), 1U);
  EXPECT_EQ(back().settings.named.clip, "morph");
}

TEST_F(SceneWriter, MediaWithoutNeedStayOutAndNamesAreMadeUnique) {
  LoadedScene loaded = loadSceneFile(model());
  EXPECT_THAT(written(loaded), HasSubstr("\nmedium = \"marble\"\n"));
  EXPECT_THAT(written(loaded), Not(HasSubstr("[media")));
  EXPECT_THAT(written(loaded), Not(HasSubstr("[objects")));
  // One medium that merely calls itself marble, and one with an empty name.
  loaded.scene.objects[0].medium.eta = 1.7;
  loaded.scene.objects[2].medium = {"", {1, 1, 1}, {2, 2, 2}, 1.2};
  written(loaded);
  const Scene again = back().scene;
  EXPECT_TRUE(again.objects[1].medium == loaded.scene.objects[1].medium);
  EXPECT_EQ(again.objects[0].medium.name, "marble 2");
  EXPECT_EQ(again.objects[0].medium.eta, 1.7);
  EXPECT_EQ(again.objects[0].medium.sigmaAPerMm, loaded.scene.objects[0].medium.sigmaAPerMm);
  EXPECT_EQ(again.objects[2].medium.sigmaAPerMm[1], 2);
}

TEST_F(SceneWriter, TheDarkStaysDark) {
  LoadedScene loaded = loadSceneFile(model());
  loaded.scene.lighting = {};
  written(loaded);
  expectSameLighting(back().scene.lighting, {});
}

TEST_F(SceneWriter, RefusesWhatNoSceneCanSay) {
  const LoadedScene good = loadSceneFile(model());
  LoadedScene bad = good;
  bad.scene.objects[1].name = bad.scene.objects[0].name;
  EXPECT_EQ(written(bad).substr(0, 1), "#");  // alike, they may share a name
  bad.scene.objects[1].medium = findMedium("ketchup").value();
  EXPECT_THAT(complaint(bad), AllOf(HasSubstr("'plain'"), HasSubstr("names of their own")));
  bad = good;
  bad.scene.lighting.environment = std::make_shared<const Image>(test::sky());
  EXPECT_THAT(complaint(bad), HasSubstr("environment"));
  bad = good;
  bad.scene.camera.positionMm[0] = NAN;
  EXPECT_THAT(complaint(bad), HasSubstr("position"));
  bad = good;
  bad.scene.camera.targetMm = bad.scene.camera.positionMm;
  EXPECT_THAT(complaint(bad), HasSubstr("camera"));
  bad = good;
  bad.scene.objects[0].medium.eta = 5;
  EXPECT_THAT(complaint(bad), AllOf(HasSubstr("'plain'"), HasSubstr("eta 5")));
  bad = good;
  bad.scene.lighting.ambient = {0, -1, 0};
  EXPECT_THAT(complaint(bad), HasSubstr("radiance 0,-1,0"));
  bad = good;
  bad.scene.deformers = {{DeformerKind::Bend, 7, 0}};
  EXPECT_THAT(complaint(bad), HasSubstr("bend"));
  bad = good;
  bad.source.models[0].file = folder / "caf\xE9.obj";
  EXPECT_THAT(complaint(bad), HasSubstr("UTF-8"));
  EXPECT_THROW(writeScene(folder / "a.ply", describe(good.scene, good.source, {})), UsageError);
}

TEST_F(SceneWriter, AFileThatCannotBeWrittenStaysAsItWas) {
  LoadedScene loaded = loadSceneFile(model());
  const std::string before = written(loaded);
  loaded.scene.objects[0].medium.eta = NAN;
  EXPECT_NE(complaint(loaded), "");
  EXPECT_EQ(test::readBytes(file()), before);
}

}  // namespace
}  // namespace opaline
