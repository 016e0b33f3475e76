// Describes a scene as a scene file does; writer.cpp makes the text.
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bssrdf/profile.h"
#include "opaline/error.h"
#include "opaline/options/scene.h"
#include "opaline/scene_file.h"

namespace opaline::scene {

namespace {

/// Whether a translucent object is exactly what its material from the scene file makes it. If not,
/// its medium is another one, on which the material's textures may have stayed.
bool isAsItsMaterial(const Object& object, const MaterialSource& material) {
  return !material.isOpaque && bssrdf::isSameInside(object.medium, material.became) &&
         object.paint.has_value() == material.textures.contains("color_texture");
}

/// Keeps numbers that differ from those of the object's material, for the kind of object that it is
/// now.
void keepNumbers(const Object& object, SceneSource& source) {
  const auto found = source.numbersOfObject.find(object.name);
  if (found == source.numbersOfObject.end()) return;
  MaterialNumbers& numbers = found->second;
  if (object.opaque) {
    numbers.surface = {};
    return;
  }
  if (!numbers.opaque.empty() && object.surface)
    numbers.surface = options::chosenIn(*object.surface);
  numbers.opaque = {};
}

void describeObject(const Object& object, SceneDescription& description) {
  keepNumbers(object, description.source);
  const auto& materials = description.source.materialOfObject;
  const auto name = materials.find(object.name);
  const bool isNamed = name != materials.end();
  description.mediaOfAll = description.mediaOfAll && !isNamed && !object.opaque;
  // The model's file or a material makes an object opaque.
  if (object.opaque) return;
  if (isNamed && isAsItsMaterial(object, description.source.materials.at(name->second))) return;
  description.mediaOfAll = description.mediaOfAll && !object.paint;
  description.media.push_back({object.name, object.medium, object.paint.has_value()});
}

template <typename T>
void copyEntry(const std::string& from, const std::string& to, std::map<std::string, T>& entries) {
  const auto found = entries.find(from);
  if (found == entries.end())
    entries.erase(to);
  else
    entries[to] = found->second;
}

/// Describes an object's duplicates like the object itself: loading the models brings them back.
void describeDuplicates(const Object& object, SceneDescription& description) {
  std::vector<SceneDescription::ObjectMedium>& media = description.media;
  const bool hasMedium = !media.empty() && media.back().object == object.name;
  for (const std::string& name : object.duplicates) {
    copyEntry(object.name, name, description.source.materialOfObject);
    copyEntry(object.name, name, description.source.numbersOfObject);
    if (!hasMedium) continue;
    media.push_back(SceneDescription::ObjectMedium(media.back()));
    media.back().object = name;
  }
}

}  // namespace

}  // namespace opaline::scene

namespace opaline {

std::optional<Ground> describeGround(const Scene& scene) {
  const Object* ground = groundOf(scene);
  if (ground == nullptr) return std::nullopt;
  return Ground{ground->opaque->baseColor, ground->mesh.positionsMm[0][1]};
}

SceneDescription describe(const Scene& scene, SceneSource source, SceneFileSettings settings) {
  const Lighting& lighting = scene.lighting;
  if (lighting.environment && !source.environment) {
    throw Error("the environment was read from no file that a scene file could name");
  }
  SceneDescription description;
  description.source = std::move(source);
  if (!lighting.environment) description.source.environment.reset();
  description.centreMm = middleOf(boundsOf(scene));
  description.ground = describeGround(scene);
  if (description.ground) *description.ground->heightMm -= description.centreMm[1];
  for (const Object& object : scene.objects) {
    if (object.isGround) continue;
    scene::describeObject(object, description);
    scene::describeDuplicates(object, description);
  }
  description.directional = lighting.directional;
  description.points = lighting.points;
  description.spots = lighting.spots;
  description.areas = lighting.areas;
  description.ambient = lighting.ambient;
  description.camera = scene.camera;
  description.deformers = scene.deformers;
  description.settings = std::move(settings);
  return description;
}

}  // namespace opaline
