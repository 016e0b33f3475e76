#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "opaline/error.h"
#include "opaline/file.h"
#include "opaline/framing.h"
#include "opaline/options/scene.h"
#include "opaline/scene_file.h"
#include "scene/changes.h"
#include "scene/environment_file.h"
#include "scene/finish.h"
#include "scene/formats.h"
#include "scene/joined_models.h"
#include "scene/material.h"
#include "scene/mesh/mesh_files.h"
#include "scene/mesh/morph_to.h"
#include "scene/mesh/sequence_state.h"
#include "scene/not_shown.h"
#include "scene/raw_scene.h"
#include "scene/scene_source.h"
#include "scene/text.h"
#include "scene/toml/camera.h"
#include "scene/toml/keys.h"
#include "scene/toml/lights.h"
#include "scene/toml/materials.h"
#include "scene/toml/media.h"
#include "scene/toml/parse.h"
#include "scene/toml/paths.h"
#include "scene/toml/placement.h"
#include "scene/toml/reader.h"
#include "scene/toml/settings.h"
#include "scene/vector_math.h"

namespace opaline::scene {

namespace {

/// A .toml scene being put together; lengths in millimetres.
struct Assembly {
  const std::filesystem::path& file;
  const LoadOptions& options;
  RawScene scene{};
  SceneSource source{};
  std::vector<Repair> repairs{};
  std::optional<MeshFiles> meshes{};  ///< where the model is a sequence
  Media media{};
  std::map<std::string, TomlMaterial> materials{};
  std::vector<double> modelDiagonalsMm{};  ///< before anything is placed
  Vec3 centre{};
  /// How far a built-in scene's own camera stands from its target.
  std::optional<double> builtInDistanceDiagonals{};
  ColorModel colorModel = ColorModel::Observed;
  std::vector<NotShown> replaced{};  ///< what media do not show of the materials they replace
  std::optional<Ground> ground{};    ///< its height is relative to the centre
};

RawScene fromBuiltIn(Scene&& built) {
  RawScene raw;
  for (Object& object : built.objects) {
    RawMesh mesh;
    mesh.positions = std::move(object.mesh.positionsMm);
    mesh.normals = std::move(object.mesh.normals);
    mesh.triangles = std::move(object.mesh.triangles);
    raw.objects.push_back(
        {std::move(object.name), std::move(mesh), std::move(object.medium), std::nullopt});
  }
  raw.mmPerUnit = 1.0;
  return raw;
}

RawScene takeBuiltIn(Scene&& built, Assembly& to) {
  to.builtInDistanceDiagonals = distanceToTargetMm(built.camera) / double{diagonalMm(built)};
  return fromBuiltIn(std::move(built));
}

void replaceMaterial(const Medium& medium, RawObject& object, Assembly& to) {
  addReplaced(to.replaced, object, !object.attributes.colors.empty());
  putMedium(medium, object);
}

/// Sets the medium of all objects that are not metal, where the table names one.
void setMedium(const TomlTable& table, RawScene& model, Assembly& to) {
  const auto medium = table.text("medium");
  if (!medium) return;
  const Medium found = mediumNamed(table, "medium", *medium, to.media);
  for (std::size_t i = 0; i < model.objects.size(); ++i) {
    RawObject& object = model.objects[i];
    if (object.opaque && isMetal(*object.opaque)) continue;
    forgetMaterial(model.changes, i);
    replaceMaterial(found, object, to);
  }
}

bool hasTextures(const Assembly& from) {
  return std::any_of(from.materials.begin(), from.materials.end(),
                     [](const auto& named) { return !named.second.source.textures.empty(); });
}

/// Loads the model that the table names under `key`, in millimetres.
RawScene loadModelOf(const TomlTable& table, std::string_view key, bool isOnly, Assembly& to) {
  const auto model = table.text(key);
  if (!model) {
    table.fail("", fmt::format("has no '{}', a file or builtin:bear or builtin:teapot", key));
  }
  const auto diagonal =
      table.number("diagonal_mm", options::fieldOf<LoadOptions>("diagonal_mm").allowed.range);
  std::optional<std::filesystem::path> morphTo = to.options.morphTo;
  if (const auto name = table.text("morph_to"); name && !morphTo) morphTo = beside(to.file, *name);
  if (model->empty()) table.fail(key, "must not be empty");
  if (table.has("morph_to") && model->starts_with("builtin:"))
    table.fail("morph_to", "needs a model from a file: a built-in one turns into no other mesh");
  ModelSource& source = to.source.models.emplace_back();
  source = {*model, diagonal, morphTo, {}};
  LoadOptions builtInOptions;
  builtInOptions.log = to.options.log;
  if (diagonal) builtInOptions.diagonalMm = static_cast<float>(*diagonal);
  builtInOptions.morphTo = morphTo;
  if (*model == "builtin:bear") return takeBuiltIn(builtInBear(builtInOptions), to);
  if (*model == "builtin:teapot") return takeBuiltIn(builtInTeapot(builtInOptions), to);
  if (model->starts_with("builtin:")) {
    table.fail(key, "names no built-in model; there are builtin:bear and builtin:teapot");
  }
  const std::filesystem::path path = beside(to.file, *model);
  if (path.extension() == ".toml") table.fail(key, "must not be another .toml scene");
  const bool noteUnit = !diagonal && !to.options.diagonalMm;
  if (MeshSequence::isPattern(path)) {
    if (!isOnly) table.fail(key, "stands for numbered meshes, which must be a scene's only model");
    to.meshes.emplace(path, morphTo);
  }
  // Meshes of a sequence are matched vertex by vertex, so theirs must not be split for coordinates.
  const bool wantsCoordinates = !to.meshes && !morphTo && hasTextures(to);
  RawScene raw =
      to.meshes ? to.meshes->loadFirst(to.options.log)
                : loadModel(path, to.options.log,
                            {.wantsCoordinates = wantsCoordinates, .colorModel = to.colorModel});
  if (morphTo) addMorph(raw, path, *morphTo, to.options.log);
  raw = inMillimetres(std::move(raw), path, noteUnit, to.options.log, to.repairs);
  if (to.meshes) to.meshes->followRepairs(raw);
  source.file = path;
  if (diagonal) scaleBy(raw, *diagonal / diagonalOf(boundsOf(raw)), to.file.string());
  return raw;
}

/// Loads the root's model, or those of [[models]], each placed by its table.
void loadModels(const TomlTable& root, Assembly& to) {
  const std::vector<TomlTable> tables = root.tables("models");
  if (tables.empty()) {
    to.scene = loadModelOf(root, "model", true, to);
    to.modelDiagonalsMm.push_back(diagonalOf(boundsOf(to.scene)));
    return setMedium(root, to.scene, to);
  }
  for (const std::string_view key : {"model", "diagonal_mm", "morph_to"}) {
    if (root.has(key)) root.fail(key, "cannot stand beside [[models]], each of which has its own");
  }
  if (to.options.morphTo && tables.size() > 1) {
    throw UsageError(
        "LoadOptions::morphTo is for a scene of one model; in [[models]] each has its morph_to");
  }
  JoinedModels joined(to.scene);
  for (const TomlTable& table : tables) {
    table.requireKeys(keys::model);
    RawScene model = loadModelOf(table, "file", tables.size() == 1, to);
    to.modelDiagonalsMm.push_back(diagonalOf(boundsOf(model)));
    setMedium(root, model, to);
    setMedium(table, model, to);
    ModelSource& source = to.source.models.back();
    source.placement = readPlacement(table);
    if (source.placement) place(model, *source.placement, table);
    joined.add(std::move(model));
  }
  if (tables.size() > 1) to.builtInDistanceDiagonals.reset();
}

/// The material that the table names; none where it names none.
std::optional<std::pair<std::string, TomlMaterial>> materialNamed(const TomlTable& table,
                                                                  const Assembly& from) {
  const auto name = table.text("material");
  if (!name) return std::nullopt;
  const auto found = from.materials.find(*name);
  if (found == from.materials.end())
    table.fail("material",
               fmt::format("names '{}', which is not under [materials]", cleanText(*name, 60)));
  return *found;
}

void noteWithoutCoordinates(const std::pair<std::string, TomlMaterial>& material,
                            const RawObject& object, const Assembly& to) {
  if (material.second.source.textures.empty()) return;
  if (!object.attributes.textureCoordinates[0].empty()) return;
  note(to.options.log,
       fmt::format("object '{}' has no texture coordinates: it shows one pixel of the textures of "
                   "material '{}'",
                   object.name, cleanText(material.first, 60)));
}

/// Reads numbers that override those of the object's material.
void readNumbers(const TomlTable& table, RawObject& object, MaterialNumbers& numbers) {
  if (object.opaque) {
    numbers.opaque = chosenIn<OpaqueMaterial>(table);
    return numbers.opaque.applyTo(*object.opaque);
  }
  for (const auto& field : options::fieldsOf<OpaqueMaterial>())
    if (options::findField<TranslucentSurface>(field.key) == nullptr && table.has(field.key))
      table.fail(field.key, "is for opaque objects, and this one is translucent");
  numbers.surface = chosenIn<TranslucentSurface>(table);
  if (numbers.surface.empty()) return;
  if (!object.surface) object.surface.emplace();
  numbers.surface.applyTo(*object.surface);
}

void readObjects(const TomlTable& root, Assembly& to) {
  const auto objects = root.table("objects");
  if (!objects) return;
  std::vector<std::string_view> names;
  for (const RawObject& object : to.scene.objects) names.emplace_back(object.name);
  const auto tables = objects->subtables();
  for (const auto& [name, table] : tables) {
    table.requireKeys(keys::object);
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      table.fail("", "names no object of the model" + suggestionOrList(name, names));
    }
    const auto medium = table.text("medium");
    const auto paint = table.value("paint", {}, options::Value(false));
    const bool keepsPaint = paint && std::get<bool>(*paint);
    if (keepsPaint && !medium)
      table.fail("paint", "says what stays on a 'medium', and there is none");
    const std::optional<Placement> placement = readPlacement(table);
    if (placement) to.source.placements.emplace(name, *placement);
    const auto material = materialNamed(table, to);
    if (material) to.source.materialOfObject.emplace(name, material->first);
    for (std::size_t i = 0; i < to.scene.objects.size(); ++i) {
      RawObject& object = to.scene.objects[i];
      if (object.name != name) continue;
      if (material || medium) forgetMaterial(to.scene.changes, i);
      if (material) {
        noteWithoutCoordinates(*material, object, to);
        object.opaque = material->second.opaque;
        object.medium = material->second.translucent.medium;
        object.paint = material->second.translucent.paint;
        object.surface = material->second.translucent.surface;
      }
      if (medium) {
        std::optional<Paint> kept;
        if (keepsPaint) kept.swap(object.paint);
        replaceMaterial(mediumNamed(table, "medium", *medium, to.media), object, to);
        object.paint = std::move(kept);
      }
      MaterialNumbers numbers;
      readNumbers(table, object, numbers);
      if (numbers != MaterialNumbers{}) to.source.numbersOfObject[name] = numbers;
      if (placement) place(object, *placement, table);
    }
  }
}

void readColorModel(const TomlTable& root, Assembly& to) {
  to.source.colorModel = to.options.colorModel;
  if (const auto name = root.choice("color_model", options::namesOf<ColorModel>());
      name && !to.source.colorModel)
    to.source.colorModel = options::named<ColorModel>(*name);
  to.colorModel = to.source.colorModel.value_or(ColorModel::Observed);
}

void loadMaterials(const TomlTable& root, Assembly& to) {
  to.materials =
      readMaterials(root, to.file, to.colorModel,
                    [&](const TomlTable& table, std::string_view key, const std::string& name) {
                      return mediumNamed(table, key, name, to.media);
                    });
  for (auto& [name, material] : to.materials) {
    material.source.became = material.translucent.medium;
    to.source.materials.emplace(name, material.source);
  }
}

void readDeformers(const TomlTable& root, Assembly& to) {
  for (const TomlTable& table : root.tables("deform")) {
    table.requireKeys(keys::deform);
    const options::Chosen<Deformer> chosen = chosenIn<Deformer>(table);
    if (!chosen.has("kind")) table.fail("", "has no 'kind': twist, bend, squash or wobble");
    if (!chosen.has("amount")) table.fail("", "has no 'amount'");
    Deformer deformer;
    chosen.applyTo(deformer);
    const std::string complaint = options::complaintAbout(deformer);
    if (!complaint.empty()) table.fail("", complaint);
    to.scene.deformers.push_back(deformer);
  }
}

void readLighting(const TomlTable& root, Assembly& to) {
  const std::vector<TomlTable> lights = root.tables("lights");
  const auto environment = root.table("environment");
  if (root.has("lights") || environment) {
    to.scene.lighting = {};
    to.scene.hasLights = true;
    for (ClipChanges& changes : to.scene.changes)
      changes = {.cameras = std::move(changes.cameras),
                 .surfaces = std::move(changes.surfaces),
                 .media = std::move(changes.media)};
  }
  for (const TomlTable& light : lights) readLight(light, to.centre, to.scene.lighting);
  if (!environment) return;
  environment->requireKeys(keys::environment);
  const auto file = environment->text("file");
  if (!file) environment->fail("", "has no 'file'");
  EnvironmentFile from{beside(to.file, *file)};
  chosenIn<EnvironmentFile>(*environment).applyTo(from);
  to.scene.lighting.environment = readEnvironment(from);
  to.source.environment = std::move(from);
}

/// Sets the camera of a built-in scene, for what has become of its model.
void frameBuiltIn(Assembly& to) {
  if (!to.builtInDistanceDiagonals) return;
  const double distance = *to.builtInDistanceDiagonals * diagonalOf(boundsOf(to.scene));
  Camera camera;
  camera.targetMm = to.centre;
  camera.positionMm = toFloat(toDouble(to.centre) + Double3{0, 0, distance});
  to.scene.camera = camera;
}

void readGround(const TomlTable& root, Assembly& to) {
  const auto table = root.table("ground");
  if (!table) return;
  table->requireKeys(keys::ground);
  Ground ground;
  chosenIn<Ground>(*table).applyTo(ground);
  to.ground = ground;
}

void addGround(Ground ground, double factor, Scene& scene) {
  if (ground.heightMm) {
    const double heightMm = factor * double{*ground.heightMm};
    ground.heightMm = static_cast<float>(double{middleOf(boundsOf(scene))[1]} + heightMm);
  }
  scene.objects.push_back(groundUnder(scene, ground));
}

LoadedScene loadToml(const std::filesystem::path& file, const LoadOptions& options) {
  requireSensible(options);
  const toml::table parsed = parseToml(file);
  const TomlTable root(file, parsed, "the scene");
  root.requireKeys(keys::root);
  LoadedScene loaded;
  loaded.settings = readSettings(root, options.log);
  LoadOptions quieter = options;
  quieter.log = eachOnce(options.log);
  Assembly assembly{file, quieter};
  assembly.source.sceneFile = file;
  readColorModel(root, assembly);
  assembly.media = readMedia(root);
  loadMaterials(root, assembly);
  loadModels(root, assembly);
  readObjects(root, assembly);
  noteReplaced(assembly.replaced, assembly.options.log, assembly.scene.notShown);
  readDeformers(root, assembly);
  assembly.centre = middleOf(boundsOf(assembly.scene));
  readLighting(root, assembly);
  frameBuiltIn(assembly);
  readCamera(root, assembly.centre, assembly.options.log, assembly.scene);
  readGround(root, assembly);
  double factor = 1;
  if (options.diagonalMm) {
    factor = double{*options.diagonalMm} / diagonalOf(boundsOf(assembly.scene));
    rescale(assembly.source, factor, assembly.modelDiagonalsMm);
  }
  loaded.source = withAbsolutePaths(std::move(assembly.source));
  loaded.scene = finished(std::move(assembly.scene), file, std::move(assembly.repairs), options);
  if (assembly.ground) addGround(*assembly.ground, factor, loaded.scene);
  if (assembly.meshes) {
    assembly.meshes->followPlace(loaded.scene);
    loaded.sequence = std::make_shared<MeshSequence>(
        MeshSequence::State{std::move(*assembly.meshes), loaded.scene});
  }
  requireClip(root, loaded);
  return loaded;
}

}  // namespace

}  // namespace opaline::scene

namespace opaline {

LoadedScene loadSceneFile(const std::filesystem::path& file, const LoadOptions& options) {
  if (scene::lowerExtension(file) != ".toml") {
    return {loadScene(file, options), {}, sourceOf(file, options)};
  }
  return scene::loadToml(file, options);
}

}  // namespace opaline
