#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/json.h"
#include "cli/material_textures.h"
#include "cli/measures.h"
#include "cli/medium_options.h"
#include "cli/object_sizes.h"
#include "cli/output.h"
#include "cli/paths.h"
#include "cli/scene_options.h"
#include "opaline/atlas.h"
#include "opaline/error.h"
#include "opaline/file.h"
#include "opaline/half_space.h"
#include "opaline/image_file.h"
#include "opaline/material.h"
#include "opaline/mesh.h"
#include "opaline/options/scene.h"
#include "opaline/renderer.h"
#include "opaline/scene.h"
#include "opaline/scene_file.h"
#include "opaline/sequence.h"
#include "opaline/tone.h"

namespace opaline::app {

namespace {

constexpr int atlasPictureTexels = 1024;

struct InfoCommand {
  SceneOptions scene;
  std::optional<std::filesystem::path> atlas;
  bool quiet = false;
  bool json = false;

  void addTo(CommandLine& line) {
    line.section("Scene");
    scene.addTo(line);
    line.section("Options");
    line.value("--atlas", "FILE.png", "make, measure and draw the paper's atlas",
               [this](const Given& given) { atlas = readOutput(given, {".png"}); });
    line.outputFlags("one JSON object on standard output", json, quiet);
  }
};

const std::string& materialName(const Object& object) {
  return object.opaque ? object.opaque->name : object.medium.name;
}

Json objectsJson(const Scene& scene, const std::vector<BodyFacts>& bodies) {
  std::vector<std::size_t> bodyOf(scene.objects.size());
  std::vector<std::size_t> withoutInside(scene.objects.size());
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    for (std::size_t k = 0; k < bodies[body].objects.size(); ++k) {
      bodyOf[bodies[body].objects[k]] = body;
      withoutInside[bodies[body].objects[k]] = bodies[body].trianglesWithoutInside[k];
    }
  }
  Json objects = Json::array();
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    objects.push_back({{"name", object.name},
                       {"triangles", object.mesh.triangles.size()},
                       {"vertices", object.mesh.positionsMm.size()},
                       {"size_mm", sizeMm(object)},
                       {"body", bodyOf[i]},
                       {"triangles_without_inside", withoutInside[i]},
                       {"material", materialName(object)},
                       {"medium", object.opaque ? Json() : mediumJson(object.medium)}});
  }
  return objects;
}

Json textureJson(const NamedTexture& named) {
  const TexturePixels& pixels = *named.texture->pixels;
  return {{"use", named.use},
          {"name", pixels.name},
          {"width", pixels.width},
          {"height", pixels.height}};
}

Json opaqueJson(const Object& object) {
  const OpaqueMaterial& material = *object.opaque;
  Json textures = Json::array();
  for (const NamedTexture& named : texturesOf(object)) textures.push_back(textureJson(named));
  return {{"name", material.name},
          {"kind", "opaque"},
          {"base_color", material.baseColor},
          {"metallic", material.metallic},
          {"roughness", material.roughness},
          {"emission", material.emission},
          {"textures", std::move(textures)}};
}

Json translucentJson(const Object& object) {
  const Medium& medium = object.medium;
  Json textures = Json::array();
  for (const NamedTexture& named : texturesOf(object)) textures.push_back(textureJson(named));
  const bool saysRoughness = object.surface && object.surface->roughness;
  return {{"name", medium.name},
          {"kind", "translucent"},
          {"sigma_s_prime_per_mm", rgbJson(medium.sigmaSPrimePerMm)},
          {"sigma_a_per_mm", rgbJson(medium.sigmaAPerMm)},
          {"eta", medium.eta},
          {"g", medium.g},
          {"roughness", saysRoughness ? Json(*object.surface->roughness) : Json()},
          {"textures", std::move(textures)}};
}

Json materialsJson(const Scene& scene) {
  Json materials = Json::array();
  for (const Object& object : scene.objects) {
    Json material = object.opaque ? opaqueJson(object) : translucentJson(object);
    if (std::find(materials.begin(), materials.end(), material) == materials.end())
      materials.push_back(std::move(material));
  }
  return materials;
}

std::string opaqueText(const Object& object) {
  std::string text = "opaque";
  if (!object.opaque->name.empty()) text += fmt::format(" ({})", object.opaque->name);
  for (const auto& [use, texture] : texturesOf(object))
    text += fmt::format(", {} {}x{}", use, texture->pixels->width, texture->pixels->height);
  return text;
}

std::string texturesText(const Object& object) {
  const std::vector<NamedTexture> textures = texturesOf(object);
  if (textures.empty()) return {};
  std::string text = fmt::format("object {} has textures:", object.name);
  const char* separator = " ";
  for (const auto& [use, texture] : textures)
    text += fmt::format("{}{} {}x{}", std::exchange(separator, ", "), use, texture->pixels->width,
                        texture->pixels->height);
  return text + "\n";
}

Json clipsJson(const Scene& scene) {
  Json clips = Json::array();
  for (const Clip& clip : scene.clips) {
    clips.push_back({{"name", clip.name}, {"seconds", clip.seconds}});
  }
  return clips;
}

std::string motionText(const Scene& scene) {
  std::string text;
  for (const Clip& clip : scene.clips) {
    text += fmt::format("clip {}: {:.4g} s\n", clip.name, clip.seconds);
  }
  for (const Deformer& deformer : scene.deformers) {
    text += fmt::format("deform {}: {:.4g}", options::nameOf(deformer.kind), deformer.amount);
    if (deformer.periodSeconds > 0)
      text += fmt::format(", period {:.4g} s", deformer.periodSeconds);
    text += "\n";
  }
  return text;
}

/// The scene is described even where devices cannot be listed.
std::vector<DeviceDescription> devicesOrNote(const LogCallback& log) {
  try {
    return listDevices();
  } catch (const Error& error) {
    log(LogLevel::Note, error.what());
    return {};
  }
}

Json devicesJson(const LogCallback& log) {
  Json devices = Json::array();
  for (const DeviceDescription& device : devicesOrNote(log)) {
    Json entry{{"index", devices.size()}};
    entry.update(deviceJson(device));
    entry["ray_queries"] = device.rayQueries;
    devices.push_back(std::move(entry));
  }
  return devices;
}

Json sequenceJson(const MeshSequence* sequence) {
  if (sequence == nullptr) return {};
  return {{"files", sequence->frameCount()},
          {"first", sequence->file(sequence->firstNumber()).string()},
          {"last", sequence->file(sequence->lastNumber()).string()}};
}

Json atlasJson(const AtlasStatistics& statistics) {
  return {{"charts", statistics.charts},
          {"coverage", statistics.coverage},
          {"area_distortion_rms", statistics.areaDistortionRms},
          {"seconds", statistics.seconds}};
}

Json collect(const Scene& scene, const MeshSequence* sequence, const LogCallback& log) {
  std::size_t triangles = 0;
  std::size_t vertices = 0;
  for (const Object& object : scene.objects) {
    triangles += object.mesh.triangles.size();
    vertices += object.mesh.positionsMm.size();
  }
  Json repairs = Json::array();
  for (const Repair& repair : scene.repairs) {
    repairs.push_back({{"what", repair.what}, {"count", repair.count}});
  }
  Json notShown = Json::array();
  for (const NotShown& kind : scene.notShown) {
    notShown.push_back({{"what", kind.what}, {"count", kind.count}, {"names", kind.names}});
  }
  const std::vector<BodyFacts> bodies = bodiesOf(scene);
  MeshFacts sum{.closed = !bodies.empty()};
  for (const BodyFacts& body : bodies) {
    sum.closed = sum.closed && body.surface.closed;
    sum.boundaryLoops += body.surface.boundaryLoops;
    sum.components += body.surface.components;
  }
  const Bounds bounds = boundsOf(scene);
  return {{"name", scene.name},
          {"triangles", triangles},
          {"vertices", vertices},
          {"closed", sum.closed},
          {"boundary_loops", sum.boundaryLoops},
          {"components", sum.components},
          {"bounds_min_mm", bounds.minMm},
          {"bounds_max_mm", bounds.maxMm},
          {"diagonal_mm", diagonalMm(scene)},
          {"clips", clipsJson(scene)},
          {"sequence", sequenceJson(sequence)},
          {"repairs", std::move(repairs)},
          {"not_shown", std::move(notShown)},
          {"materials", materialsJson(scene)},
          {"objects", objectsJson(scene, bodies)},
          {"devices", devicesJson(log)}};
}

/// Draws the atlas into a file and describes it.
Json writeAtlas(const Scene& scene, const std::filesystem::path& file) {
  const Atlas atlas = makeAtlas(scene);
  ToneOptions plain;
  plain.curve = ToneCurve::None;
  writePng(file, toneMap(drawAtlas(atlas, atlasPictureTexels), plain));
  return atlasJson(atlas.statistics);
}

std::string sizeText(const Object& object) {
  const std::array<double, 3> mm = sizeMm(object);
  constexpr int digits = 4;
  return fmt::format("{} x {} x {} mm", lengthNumber(mm[0], digits), lengthNumber(mm[1], digits),
                     lengthNumber(mm[2], digits));
}

std::string ofChannelsText(const std::array<double, 3>& mm) {
  if (std::none_of(mm.begin(), mm.end(), [](double length) { return std::isfinite(length); }))
    return lengthNumber(mm[0]);
  return fmt::format("{} {} {} mm", lengthNumber(mm[0]), lengthNumber(mm[1]), lengthNumber(mm[2]));
}

// The bodies that consist of several objects.
std::string bodiesText(const Json& objects) {
  std::map<std::size_t, std::vector<std::string>> bodies;
  for (const Json& object : objects)
    bodies[object["body"].get<std::size_t>()].push_back(object["name"].get<std::string>());
  std::string text;
  for (const auto& [number, names] : bodies)
    if (names.size() > 1) text += fmt::format("objects {} are one body\n", fmt::join(names, ", "));
  return text;
}

std::string sceneText(const Scene& scene, const Json& facts) {
  const auto count = [&](const char* field, const char* one, const char* many) {
    const auto number = facts[field].get<std::size_t>();
    return fmt::format("{} {}", number, number == 1 ? one : many);
  };
  std::string text = fmt::format(
      "{}: {}, {}, {}, {}\n", scene.name, count("triangles", "triangle", "triangles"),
      count("vertices", "vertex", "vertices"),
      facts["closed"].get<bool>()
          ? "closed"
          : fmt::format("open ({})", count("boundary_loops", "boundary loop", "boundary loops")),
      count("components", "component", "components"));
  const Bounds bounds = boundsOf(scene);
  const double diagonal = diagonalMm(scene);
  const auto corner = [&](const Vec3& mm) {
    return fmt::format("{}, {}, {} mm", coordinateNumber(mm[0], diagonal),
                       coordinateNumber(mm[1], diagonal), coordinateNumber(mm[2], diagonal));
  };
  text += fmt::format("from {} to {}, diagonal {}\n", corner(bounds.minMm), corner(bounds.maxMm),
                      lengthText(diagonal, 4));
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    if (object.opaque) {
      text += fmt::format("object {}: {}, {}\n", object.name, sizeText(object), opaqueText(object));
      continue;
    }
    const MediumLengths lengths = lengthsOf(object.medium);
    text +=
        fmt::format("object {}: {} of {}, mean free path {}, diffusion length {}\n", object.name,
                    sizeText(object), object.medium.name, ofChannelsText(lengths.meanFreePathMm),
                    ofChannelsText(lengths.diffusionMm));
    text += texturesText(object);
    const auto open = facts["objects"][i]["triangles_without_inside"].get<std::size_t>();
    if (open > 0)
      text += fmt::format(
          "{} {} is open and has no inside for --transport boundary: light scatters there as in a "
          "half-space, by better-dipole\n",
          open < object.mesh.triangles.size() ? "a part of object" : "object", object.name);
  }
  text += bodiesText(facts["objects"]);
  text += motionText(scene);
  if (const Json& sequence = facts["sequence"]; !sequence.is_null()) {
    const int files = sequence["files"].get<int>();
    text += fmt::format("sequence of {} file{}, {} to {}\n", files, files == 1 ? "" : "s",
                        sequence["first"].get<std::string>(), sequence["last"].get<std::string>());
  }
  for (const Repair& repair : scene.repairs) {
    text += fmt::format("repaired: {} {}\n", repair.count, repair.what);
  }
  if (!scene.notShown.empty()) {
    text += fmt::format("not shown: {}\n", textOf(scene.notShown));
  }
  return text;
}

std::string restText(const Json& facts) {
  std::string text;
  if (facts.contains("atlas")) {
    const Json& atlas = facts["atlas"];
    text +=
        fmt::format("atlas: {} charts, {:.1f} % covered, area distortion {:.4f} rms, {:.2f} s\n",
                    atlas["charts"].get<std::size_t>(), 100 * atlas["coverage"].get<double>(),
                    atlas["area_distortion_rms"].get<double>(), atlas["seconds"].get<double>());
  }
  for (const Json& device : facts["devices"]) {
    text += fmt::format("device {}: {}, {}, {}{}\n", device["index"].get<std::size_t>(),
                        device["name"].get<std::string>(), device["type"].get<std::string>(),
                        device["driver"].get<std::string>(),
                        device["ray_queries"].get<bool>() ? ", ray queries" : "");
  }
  if (facts["devices"].empty()) text += "no Vulkan device was found\n";
  return text;
}

}  // namespace

void runInfo(const Arguments& arguments) {
  CommandLine line("info",
                   "Shows the contents of a scene, its size beside its medium's mean free path, "
                   "its repairs, and the devices.");
  InfoCommand command;
  command.addTo(line);
  if (!line.parse(arguments)) return;
  if (command.atlas) requireWritable(*command.atlas);

  const LogCallback log = noteTaker(command.quiet);
  LoadedScene loaded = command.scene.load(log);
  removeGround(loaded.scene);
  const Scene& scene = loaded.scene;
  if (command.atlas) requireNoInput({{"--atlas", *command.atlas}}, filesOf(loaded.source));
  for (const std::string& note : notesOnSize(scene)) log(LogLevel::Note, note);
  Json facts = collect(scene, loaded.sequence.get(), log);
  if (command.atlas) {
    facts["atlas"] = writeAtlas(scene, *command.atlas);
    log(LogLevel::Note, fmt::format("wrote {}", command.atlas->string()));
  }
  printOut(command.json ? toText(facts) : sceneText(scene, facts) + restText(facts));
}

}  // namespace opaline::app
