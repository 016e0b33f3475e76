#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "cli/fields.h"
#include "cli/motion_options.h"
#include "cli/picture_options.h"
#include "opaline/error.h"
#include "opaline/options/picture.h"
#include "opaline/scene_file.h"

// Every option of the table by every way that sets it: the library, the command line and scene
// files, there and back.

namespace opaline::app {
namespace {

using options::PictureSettings;
using options::Value;
using PictureField = options::Field<PictureSettings>;
using testing::HasSubstr;

std::vector<PictureField> numbers() {
  std::vector<PictureField> found;
  for (const PictureField& field : options::fieldsOf<PictureSettings>())
    if (!std::holds_alternative<bool>(field.like) &&
        !std::holds_alternative<std::string>(field.like))
      found.push_back(field);
  return found;
}

bool isOnByDefault(const PictureField& field) {
  return field.get(PictureSettings{}) == Value{true};
}

/// A value that is allowed and not the default.
Value another(const PictureField& field) {
  const options::Range& range = field.allowed.range;
  const auto pick = [&](const auto& like) -> Value {
    using Kind = std::remove_cvref_t<decltype(like)>;
    if constexpr (std::is_same_v<Kind, bool>)
      return !isOnByDefault(field);
    else if constexpr (std::is_same_v<Kind, std::string>)
      return std::string(field.allowed.choices[1]);
    else if constexpr (std::is_same_v<Kind, int>)
      return static_cast<int>(range.most);
    else if constexpr (std::is_arithmetic_v<Kind>)
      return static_cast<Kind>(range.most / 2);
    else
      return Kind{typename Kind::value_type{1}, static_cast<typename Kind::value_type>(range.most)};
  };
  return std::visit(pick, field.like);
}

std::string nameOf(const PictureField& field) {
  if (field.key == "seconds") return "--time";
  if (isOnByDefault(field)) return "--no-" + std::string(field.key);
  return optionOf(field.key);
}

/// What an option needs beside it, by key.
std::vector<std::pair<std::string, std::string>> neededBeside(const PictureField& field) {
  if (field.key.starts_with("near_") || field.key == "far_distance") return {{"sum", "pattern"}};
  if (field.key == "ambient_occlusion") return {{"transport", "dipole"}};
  return {};
}

/// What the command line makes of it, where `text` is typed after the option.
PictureSettings typed(const PictureField& field, const std::string& text) {
  PictureOptions picture;
  MotionOptions motion;
  MethodOptions method;
  CommandLine line("render", "");
  picture.addTo(line);
  motion.addTo(line);
  method.addTo(line);
  std::vector<std::string> arguments{nameOf(field)};
  if (!text.empty()) arguments.push_back(text);
  for (const auto& [key, value] : neededBeside(field))
    arguments.insert(arguments.end(), {"--" + key, value});
  EXPECT_TRUE(line.parse(arguments));
  PictureSettings settings;
  method.applyTo(settings.render, {});
  picture.applyTo(settings.render);
  settings.time = motion.time({}, {});
  settings.tone = picture.tone({}, {});
  return settings;
}

class OptionsTable : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "cube.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                           "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  LoadedScene load(const std::string& settings) {
    std::ofstream(folder_ / "scene.toml") << "model = \"cube.obj\"\n[render]\n" << settings << "\n";
    return loadSceneFile(folder_ / "scene.toml", {});
  }

  std::string refusal(const std::string& settings) {
    try {
      load(settings);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  std::filesystem::path folder_ = std::filesystem::path(testing::TempDir()) / "options_table";
};

TEST_F(OptionsTable, TheCommandLineSetsEach) {
  for (const PictureField& field : options::fieldsOf<PictureSettings>()) {
    const Value value = another(field);
    const bool flag = std::holds_alternative<bool>(field.like);
    const PictureSettings settings = typed(field, flag ? "" : options::textOf(value));
    EXPECT_EQ(field.get(settings), value) << field.key;
  }
}

TEST_F(OptionsTable, SceneFilesKeepEach) {
  for (const PictureField& field : options::fieldsOf<PictureSettings>()) {
    LoadedScene loaded = load("");
    EXPECT_TRUE(loaded.settings.picture.empty());
    loaded.settings.picture.set(field, another(field));
    for (const auto& [key, value] : neededBeside(field))
      loaded.settings.picture.set(options::fieldOf<PictureSettings>(key), value);
    const std::filesystem::path file = folder_ / "written.toml";
    writeScene({file, Existing::Replace}, describe(loaded.scene, loaded.source, loaded.settings));
    EXPECT_EQ(loadSceneFile(file, {}).settings, loaded.settings) << field.key;
  }
}

TEST_F(OptionsTable, SceneFilesKeepNames) {
  LoadedScene loaded = load("device = 'some \"device\"'\nclip = 'none'");
  EXPECT_EQ(loaded.settings.named, (options::NamedSettings{"some \"device\"", "none"}));
  const std::filesystem::path file = folder_ / "written.toml";
  writeScene({file, Existing::Replace}, describe(loaded.scene, loaded.source, loaded.settings));
  EXPECT_EQ(loadSceneFile(file, {}).settings, loaded.settings);
  for (const auto& field : options::fieldsOf<options::NamedSettings>()) {
    EXPECT_THAT(refusal(std::string(field.key) + " = 3.5"), HasSubstr("must be a name"));
    EXPECT_THAT(refusal(std::string(field.key) + " = ''"), HasSubstr("must be a name"));
  }
}

TEST_F(OptionsTable, SceneFilesTakeTheNumberOfADevice) {
  EXPECT_EQ(load("device = 3").settings.named.device, "3");
  EXPECT_THAT(refusal("device = -1"), HasSubstr("must be a name, or a number from 0 to 255"));
  EXPECT_THAT(refusal("clip = 3"), HasSubstr("must be a name"));
}

TEST_F(OptionsTable, BothNamesOfAnOptionAreRefused) {
  for (const PictureField& field : options::fieldsOf<PictureSettings>()) {
    if (field.formerKey.empty()) continue;
    const std::string value = options::textOf(another(field));
    const std::string former(field.formerKey);
    const std::string key(field.key);
    EXPECT_THAT(refusal(former + " = " + value + "\n" + key + " = " + value),
                HasSubstr("'" + key + "' in [render] stands beside '" + former + "'"));
  }
}

TEST_F(OptionsTable, NumbersOutOfRangeAreRefusedWithTheSameSentenceEverywhere) {
  for (const PictureField& field : numbers()) {
    for (const double number : {field.allowed.range.least - 1, field.allowed.range.most + 1}) {
      const std::string sentence = options::typedRequirement(field.allowed, field.like);
      const std::string one = fmt::format("{}", number);
      const bool size = std::holds_alternative<options::Size>(field.like);
      const bool color = std::holds_alternative<Rgb>(field.like);
      try {
        typed(field, size ? one + "x" + one : one);
        ADD_FAILURE() << field.key << " " << one;
      } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), HasSubstr(sentence));
      }
      const std::string spelled = size    ? fmt::format("[{0}, {0}]", one)
                                  : color ? fmt::format("[{0}, {0}, {0}]", one)
                                          : one;
      EXPECT_THAT(refusal(std::string(field.key) + " = " + spelled), HasSubstr(sentence));
    }
  }
}

TEST_F(OptionsTable, NamesThatAreNoneAreRefusedWithTheSameSentenceEverywhere) {
  for (const PictureField& field : options::fieldsOf<PictureSettings>()) {
    if (!std::holds_alternative<std::string>(field.like)) continue;
    const std::string sentence = options::requirement(field.allowed, field.like);
    EXPECT_THAT(refusal(std::string(field.key) + " = \"xyzzy\""), HasSubstr(sentence));
    try {
      typed(field, "xyzzy");
      ADD_FAILURE() << field.key;
    } catch (const UsageError& error) {
      EXPECT_THAT(error.what(), HasSubstr(sentence));
    }
  }
}

TEST_F(OptionsTable, OlderNamesSetTheSameWithANote) {
  for (const PictureField& field : options::fieldsOf<PictureSettings>()) {
    if (field.formerKey.empty()) continue;
    PictureField former = field;
    former.key = field.formerKey;
    const Value value = another(field);
    EXPECT_EQ(field.get(typed(former, options::textOf(value))), value);
    std::vector<std::string> notes;
    load("");
    std::ofstream(folder_ / "former.toml") << "model = \"cube.obj\"\n[render]\n"
                                           << former.key << " = " << options::textOf(value) << "\n";
    LoadOptions options;
    options.log = [&](LogLevel, std::string_view note) { notes.emplace_back(note); };
    const LoadedScene loaded = loadSceneFile(folder_ / "former.toml", options);
    EXPECT_EQ(*loaded.settings.picture.find(field.key), value);
    EXPECT_THAT(notes, testing::Contains(HasSubstr(std::string(field.key))));
  }
}

}  // namespace
}  // namespace opaline::app
