#include "opaline/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

#include "bssrdf/profile.h"
#include "opaline/error.h"
#include "opaline/media.h"
#include "opaline/options/scene.h"
#include "scene/environment_file.h"
#include "scene/finish.h"
#include "scene/text.h"
#include "scene/toml/settings.h"
#include "scene/toml/spelling.h"
#include "scene/vector_math.h"

namespace opaline::scene {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view heading =
    "# A scene of Opaline, which `opaline render` draws. Lengths are mm, angles degrees, light is\n"
    "# linear RGB, scattering and absorption are per mm; places are counted from the middle of "
    "the\n"
    "# box around all objects at rest. Paths are relative to this file.\n\n";

/// A file that grows line by line.
class Text {
 public:
  void line(std::string_view words) { lines_ += fmt::format("{}\n", words); }
  void header(std::string_view words) { lines_ += fmt::format("\n{}\n", words); }
  void raw(std::string_view key, std::string_view value) {
    lines_ += fmt::format("{} = {}\n", key, value);
  }
  void text(std::string_view key, std::string_view value) { raw(key, toml_text::text(value, key)); }
  template <typename Number>
  void number(std::string_view key, Number value) {
    raw(key, toml_text::number(value, key));
  }
  template <typename Numbers>
  void list(std::string_view key, const Numbers& values) {
    raw(key, toml_text::list(values, key));
  }

  void value(std::string_view key, bool on) { raw(key, on ? "true" : "false"); }
  void value(std::string_view key, int number) { raw(key, fmt::format("{}", number)); }
  void value(std::string_view key, float number) { this->number(key, number); }
  void value(std::string_view key, double number) { this->number(key, number); }
  void value(std::string_view key, const std::string& words) { text(key, words); }
  void value(std::string_view key, const options::Size& size) {
    raw(key, fmt::format("[{}, {}]", size[0], size[1]));
  }
  template <typename Number>
  void value(std::string_view key, const std::array<Number, 3>& numbers) {
    list(key, numbers);
  }

  /// Writes those of an Owner's options that were chosen.
  template <typename Owner>
  void fields(const options::Chosen<Owner>& chosen) {
    for (const options::Field<Owner>& field : options::fieldsOf<Owner>())
      if (const options::Value* found = chosen.find(field.key))
        std::visit([&](const auto& member) { value(field.key, member); }, *found);
  }

  const std::string& lines() const { return lines_; }

 private:
  std::string lines_{heading};
};

bool isKnown(const std::string& name, const Medium& medium) {
  const auto known = findMedium(name);
  return known && known->name == name && bssrdf::isSameInside(*known, medium);
}

/// The media of a scene, each under a unique name.
class MediaNames {
 public:
  explicit MediaNames(const SceneDescription& scene) {
    // Media of the built-in tables keep their names, even if another medium has the same one.
    for (const auto& [object, medium, isPainted] : scene.media) {
      if (isKnown(medium.name, medium)) names_.emplace(medium.name, medium);
    }
    for (const auto& [object, medium, isPainted] : scene.media) {
      const std::string complaint = complaintAbout(medium);
      if (!complaint.empty()) {
        throw Error(fmt::format("the medium of object '{}': {}", cleanText(object), complaint));
      }
      names_.emplace(nameOf(medium), medium);
    }
  }

  /// The name that a medium has or would get.
  std::string nameOf(const Medium& medium) const {
    const std::string own = medium.name.empty() ? "medium" : cleanText(medium.name);
    std::string name = own;
    for (int number = 2; names_.contains(name) && !bssrdf::isSameInside(names_.at(name), medium);
         ++number) {
      name = fmt::format("{} {}", own, number);
    }
    return name;
  }

  const std::map<std::string, Medium>& all() const { return names_; }

 private:
  std::map<std::string, Medium> names_;
};

/// The path relative to the scene's folder where possible. It stays absolute where the two share
/// only the root, as a relative path would be no more portable then.
std::string written(const fs::path& path, const fs::path& sceneFile) {
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(fs::absolute(sceneFile).parent_path(), error);
  if (error) return fs::absolute(path).string();
  // The file itself may be a link whose target is meant to change, so only its folder is resolved.
  const fs::path parent = fs::weakly_canonical(fs::absolute(path).parent_path(), error);
  if (error) return fs::absolute(path).string();
  const fs::path whole = parent / path.filename();
  const auto [inFolder, inWhole] =
      std::mismatch(folder.begin(), folder.end(), whole.begin(), whole.end());
  const auto common = std::distance(folder.begin(), inFolder);
  if (common <= 1 && folder != folder.root_path()) return whole.string();
  const fs::path relative = whole.lexically_relative(folder);
  // A path that starts with "builtin:" would not mean a file.
  const bool ambiguous = relative.string().starts_with("builtin:");
  return ambiguous ? (fs::path(".") / relative).string() : relative.string();
}

void addModel(const ModelSource& model, std::string_view key, const fs::path& file, Text& to) {
  to.text(key, model.isBuiltIn() ? model.file.string() : written(model.file, file));
  if (model.diagonalMm) to.number("diagonal_mm", *model.diagonalMm);
  if (model.morphTo) to.text("morph_to", written(*model.morphTo, file));
}

/// Whether models need tables. A single model without a placement does not.
bool needTables(const std::vector<ModelSource>& models) {
  return models.size() != 1 || models.front().placement;
}

void addPlacement(const Placement& placement, Text& to) {
  if (placement.rows) return to.list("transform", *placement.rows);
  if (placement.translationMm != Vec3{}) to.list("translation_mm", placement.translationMm);
  if (placement.rotationDegrees != Vec3{}) to.list("rotation_degrees", placement.rotationDegrees);
  if (placement.scale != 1) to.number("scale", placement.scale);
}

void addModels(const std::vector<ModelSource>& models, const fs::path& file, Text& to) {
  for (const ModelSource& model : models) {
    to.header("[[models]]");
    addModel(model, "file", file, to);
    if (model.placement) addPlacement(*model.placement, to);
  }
}

/// Media by object name, since a scene file tells objects apart by name.
std::map<std::string, std::string> mediaOfObjects(const SceneDescription& scene,
                                                  const MediaNames& names) {
  std::map<std::string, std::string> media;
  for (const auto& [object, medium, isPainted] : scene.media) {
    const auto [entry, isFirst] = media.try_emplace(object, names.nameOf(medium));
    if (isFirst || entry->second == names.nameOf(medium)) continue;
    throw Error(
        fmt::format("several objects are called '{}' and are of different media, which a scene "
                    "file cannot say: give them names of their own in the model",
                    cleanText(object)));
  }
  return media;
}

void addMaterials(const SceneDescription& scene, const fs::path& file, Text& to) {
  for (const auto& [name, material] : scene.source.materials) {
    to.header(fmt::format("[materials.{}]", toml_text::key(name, "the material")));
    to.text("kind", material.isOpaque ? "opaque" : "translucent");
    if (material.medium) to.text("medium", *material.medium);
    to.fields(material.appearance);
    to.fields(material.surface);
    to.fields(material.opaque);
    for (const auto& [key, texture] : material.textures) to.text(key, written(texture, file));
  }
}

void addObjects(const SceneDescription& scene, Text& to) {
  const MediaNames names(scene);
  const std::map<std::string, std::string> media = mediaOfObjects(scene, names);
  const bool alike =
      scene.mediaOfAll && std::all_of(media.begin(), media.end(), [&](const auto& entry) {
        return entry.second == media.begin()->second;
      });
  if (alike && !media.empty()) to.text("medium", media.begin()->second);
  for (const auto& [name, medium] : names.all()) {
    if (isKnown(name, medium)) continue;
    to.header(fmt::format("[media.{}]", toml_text::key(name, "the medium")));
    to.fields(options::chosenIn(medium));
  }
  std::set<std::string> said;
  std::set<std::string> painted;
  for (const auto& [object, medium, isPainted] : scene.media)
    if (isPainted) painted.insert(object);
  if (!alike)
    for (const auto& [object, medium] : media) said.insert(object);
  for (const auto& [object, placement] : scene.source.placements) said.insert(object);
  for (const auto& [object, material] : scene.source.materialOfObject) said.insert(object);
  for (const auto& [object, numbers] : scene.source.numbersOfObject) said.insert(object);
  for (const std::string& object : said) {
    to.header(fmt::format("[objects.{}]", toml_text::key(object, "the object")));
    if (const auto medium = media.find(object); !alike && medium != media.end())
      to.text("medium", medium->second);
    if (painted.contains(object)) to.raw("paint", "true");
    const auto material = scene.source.materialOfObject.find(object);
    if (material != scene.source.materialOfObject.end()) to.text("material", material->second);
    const auto numbers = scene.source.numbersOfObject.find(object);
    if (numbers != scene.source.numbersOfObject.end()) {
      to.fields(numbers->second.opaque);
      to.fields(numbers->second.surface);
    }
    const auto placement = scene.source.placements.find(object);
    if (placement != scene.source.placements.end()) addPlacement(placement->second, to);
  }
}

template <typename Part>
void requireSensible(const Part& part, std::string_view what) {
  const std::string complaint = complaintAbout(part);
  if (!complaint.empty()) throw Error(fmt::format("{}: {}", what, complaint));
}

void addLight(std::string_view type, Text& to) {
  to.header("[[lights]]");
  to.text("type", type);
}

void addPlace(std::string_view key, const Vec3& place, const Vec3& centreMm, Text& to) {
  to.raw(key, toml_text::offset(place, centreMm, key));
}

void addShape(const RectangleLight& light, const Vec3& centreMm, Text& to) {
  addLight("rectangle", to);
  addPlace("center_mm", light.centreMm, centreMm, to);
  to.list("u_mm", light.uMm);
  to.list("v_mm", light.vMm);
  to.fields(options::chosenIn(light));
}

void addShape(const DiscLight& light, const Vec3& centreMm, Text& to) {
  addLight("disc", to);
  addPlace("center_mm", light.centreMm, centreMm, to);
  to.list("normal", light.normal);
  to.fields(options::chosenIn(light));
}

void addShape(const SphereLight& light, const Vec3& centreMm, Text& to) {
  addLight("sphere", to);
  addPlace("center_mm", light.centreMm, centreMm, to);
  to.fields(options::chosenIn(light));
}

void addShape(const TubeLight& light, const Vec3& centreMm, Text& to) {
  addLight("tube", to);
  addPlace("from_mm", light.fromMm, centreMm, to);
  addPlace("to_mm", light.toMm, centreMm, to);
  to.fields(options::chosenIn(light));
}

void addLighting(const SceneDescription& scene, const fs::path& file, Text& to) {
  for (const DirectionalLight& light : scene.directional) {
    requireSensible(light, "a directional light");
    addLight("directional", to);
    to.list("direction_to_light", light.directionToLight);
    to.fields(options::chosenIn(light));
  }
  for (const PointLight& light : scene.points) {
    requireSensible(light, "a point light");
    addLight("point", to);
    to.raw("position_mm", toml_text::offset(light.positionMm, scene.centreMm, "position_mm"));
    to.fields(options::chosenIn(light));
  }
  for (const SpotLight& light : scene.spots) {
    requireSensible(light, "a spot light");
    addLight("spot", to);
    to.raw("position_mm", toml_text::offset(light.positionMm, scene.centreMm, "position_mm"));
    to.list("direction", light.direction);
    to.fields(options::chosenIn(light));
  }
  for (const AreaLight& light : scene.areas) {
    requireSensible(light, "an area light");
    std::visit([&](const auto& shape) { addShape(shape, scene.centreMm, to); }, light);
  }
  const auto& environment = scene.source.environment;
  const bool nothingElse = scene.directional.empty() && scene.points.empty() &&
                           scene.spots.empty() && scene.areas.empty() && !environment;
  // In a file without lights, the model's lights or the default ones would shine.
  if (scene.ambient != Rgb{} || nothingElse) {
    const Lighting ambient{.ambient = scene.ambient};
    if (const std::string complaint = complaintAbout(ambient); !complaint.empty()) {
      throw Error(complaint);
    }
    addLight("ambient", to);
    to.fields(options::chosenIn(ambient));
  }
  if (!environment) return;
  to.header("[environment]");
  to.text("file", written(environment->file, file));
  to.fields(options::chosenIn(*environment));
}

void addCamera(const SceneDescription& scene, Text& to) {
  const Camera& camera = scene.camera;
  requireSensible(camera, "the camera");
  if (camera.up == Vec3{}) throw Error("the camera has no up direction");
  to.header("[camera]");
  to.raw("position_mm", toml_text::offset(camera.positionMm, scene.centreMm, "position_mm"));
  to.raw("target_mm", toml_text::offset(camera.targetMm, scene.centreMm, "target_mm"));
  to.list("up", camera.up);
  options::Chosen<Camera> chosen = options::chosenIn(camera);
  if (camera.orthographicHeightMm) chosen.erase("fov_degrees");  // unused
  to.fields(chosen);
}

void addGround(const SceneDescription& scene, Text& to) {
  if (!scene.ground) return;
  requireSensible(*scene.ground, "the ground");
  to.header("[ground]");
  to.fields(options::chosenIn(*scene.ground));
}

void addDeformers(const SceneDescription& scene, Text& to) {
  for (const Deformer& deformer : scene.deformers) {
    const std::string complaint = options::complaintAbout(deformer);
    if (!complaint.empty()) throw Error("a deformer: " + complaint);
    to.header("[[deform]]");
    options::Chosen<Deformer> chosen = options::chosenIn(deformer);
    if (deformer.periodSeconds == 0) chosen.erase("period_seconds");
    to.fields(chosen);
  }
}

void addSettings(const SceneFileSettings& settings, Text& to) {
  if (settings == SceneFileSettings{}) return;
  to.header("[render]");
  auto picture = settings.picture;
  while (const auto unused = unusedIn(picture)) picture.erase(unused->key);
  to.fields(picture);
  to.fields(options::chosenIn(settings.named));
}

}  // namespace

}  // namespace opaline::scene

namespace opaline {

std::filesystem::path writeScene(const Target& target, const SceneDescription& description) {
  const std::filesystem::path& file = target.path;
  if (file.extension() != ".toml") {
    throw UsageError(fmt::format("{}: the name of a scene file ends in .toml",
                                 scene::cleanText(file.string(), 1000)));
  }
  scene::Text text;
  const std::vector<ModelSource>& models = description.source.models;
  if (!scene::needTables(models)) scene::addModel(models.front(), "model", file, text);
  if (description.source.colorModel)
    text.text("color_model", options::nameOf(*description.source.colorModel));
  scene::addObjects(description, text);
  scene::addMaterials(description, file, text);
  if (scene::needTables(models)) scene::addModels(models, file, text);
  if (!description.lightsOfModel) scene::addLighting(description, file, text);
  if (!description.cameraOfModel) scene::addCamera(description, text);
  scene::addGround(description, text);
  scene::addDeformers(description, text);
  scene::addSettings(description.settings, text);
  return writeWhole(target, text.lines());
}

}  // namespace opaline
