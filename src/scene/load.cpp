#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <new>
#include <utility>

#include "opaline/error.h"
#include "opaline/file.h"
#include "opaline/media.h"
#include "opaline/scene_file.h"
#include "scene/finish.h"
#include "scene/formats.h"
#include "scene/joined_models.h"
#include "scene/mesh/morph_to.h"
#include "scene/not_shown.h"
#include "scene/scene_source.h"
#include "scene/text.h"

namespace opaline {

namespace scene {

std::string lowerExtension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

namespace {

enum class Format { Ply, Obj, Gltf, Unknown };

Format formatOf(const std::filesystem::path& file, std::string_view start) {
  if (start.starts_with("glTF")) return Format::Gltf;
  if (start.starts_with("ply\n") || start.starts_with("ply\r")) return Format::Ply;
  const std::string extension = lowerExtension(file);
  if (extension == ".ply") return Format::Ply;
  if (extension == ".obj") return Format::Obj;
  if (extension == ".glb" || extension == ".gltf") return Format::Gltf;
  return Format::Unknown;
}

RawScene readByName(const Input& input) {
  const std::string_view start(reinterpret_cast<const char*>(input.bytes.data()),
                               std::min<std::size_t>(input.bytes.size(), 4));
  switch (formatOf(input.file, start)) {
    case Format::Ply:
      return loadPly(input);
    case Format::Obj:
      return loadObj(input);
    case Format::Gltf:
      return loadGltf(input);
    case Format::Unknown:
      break;
  }
  throw Error(fmt::format("{}: a scene is a .glb, .gltf, .obj, .ply or .toml file",
                          cleanText(input.file.string(), 1000)));
}

ModelOptions modelOptionsOf(const LoadOptions& options) {
  return {.colorModel = options.colorModel.value_or(ColorModel::Observed)};
}

}  // namespace

void note(const LogCallback& log, std::string_view message) {
  if (log) log(LogLevel::Note, message);
}

Medium defaultMedium() {
  return findMedium("marble").value();
}

RawScene loadModel(const std::filesystem::path& file, const LogCallback& log,
                   const ModelOptions& options) {
  const std::vector<std::byte> bytes = readFile(file, longestFileBytes);
  const std::string name = cleanText(file.string(), 1000);
  if (bytes.empty()) throw Error(fmt::format("{}: the file is empty", name));
  RawScene scene = readByName({file, bytes, log, options});
  if (!scene.notShown.empty()) {
    note(log, fmt::format("{}: not shown: {}", name, textOf(scene.notShown)));
  }
  addNotShown(scene.notShown, scene.unreadable);
  return scene;
}

}  // namespace scene

LoadedScene loadSceneFiles(const std::vector<std::filesystem::path>& files,
                           const LoadOptions& options) {
  if (files.empty()) throw UsageError("a scene needs at least one file");
  if (files.size() == 1) return loadSceneFile(files.front(), options);
  scene::requireSensible(options);
  if (options.morphTo) {
    throw UsageError(fmt::format("LoadOptions::morphTo {} is for a scene of one model",
                                 scene::cleanText(options.morphTo->string(), 1000)));
  }
  scene::RawScene all;
  scene::JoinedModels joined(all);
  SceneSource source;
  source.colorModel = options.colorModel;
  std::vector<Repair> repairs;
  std::vector<double> diagonalsMm;
  for (const std::filesystem::path& file : files) {
    const std::string name = scene::cleanText(file.string(), 1000);
    if (scene::lowerExtension(file) == ".toml") {
      throw UsageError(fmt::format(
          "{}: a .toml scene stands alone; it names its models under [[models]]", name));
    }
    if (MeshSequence::isPattern(file)) {
      throw UsageError(fmt::format("{}: numbered meshes must be a scene's only model", name));
    }
    scene::RawScene model =
        scene::inMillimetres(scene::loadModel(file, options.log, scene::modelOptionsOf(options)),
                             file, !options.diagonalMm, options.log, repairs);
    diagonalsMm.push_back(scene::diagonalOf(scene::boundsOf(model)));
    source.models.push_back({file, {}, {}, {}});
    joined.add(std::move(model));
  }
  if (options.diagonalMm) {
    scene::rescale(source, double{*options.diagonalMm} / scene::diagonalOf(scene::boundsOf(all)),
                   diagonalsMm);
  }
  return {scene::finished(std::move(all), files.front(), std::move(repairs), options),
          {},
          scene::withAbsolutePaths(std::move(source)),
          nullptr};
}

Scene loadScene(const std::filesystem::path& file, const LoadOptions& options) {
  try {
    if (scene::lowerExtension(file) == ".toml") {
      LoadedScene loaded = loadSceneFile(file, options);
      if (loaded.sequence && options.log) {
        options.log(LogLevel::Note, fmt::format("{}: its model is the first of {} numbered meshes",
                                                scene::cleanText(file.string(), 1000),
                                                loaded.sequence->frameCount()));
      }
      return std::move(loaded.scene);
    }
    scene::requireSensible(options);
    scene::RawScene raw = scene::loadModel(file, options.log, scene::modelOptionsOf(options));
    if (options.morphTo) scene::addMorph(raw, file, *options.morphTo, options.log);
    std::vector<Repair> repairs;
    raw = scene::inMillimetres(std::move(raw), file, !options.diagonalMm, options.log, repairs);
    return scene::finished(std::move(raw), file, std::move(repairs), options);
  } catch (const std::bad_alloc&) {
    throw Error(fmt::format("{}: there is not enough memory to load it",
                            scene::cleanText(file.string(), 1000)));
  }
}

}  // namespace opaline
