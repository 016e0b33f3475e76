#include "scene/repair/duplicate_objects.h"

#include <bit>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "scene/changes.h"
#include "scene/hash.h"

namespace opaline::scene {

namespace {

bool stays(const Scene& scene, std::size_t object) {
  return !scene.objects[object].rig && !changesMaterial(scene, object);
}

std::uint64_t hashOf(const Mesh& mesh) {
  std::uint64_t hash = mesh.triangles.size();
  for (const Vec3& position : mesh.positionsMm)
    for (const float coordinate : position) mix(hash, std::bit_cast<std::uint32_t>(coordinate));
  return hash;
}

bool areSame(const Mesh& a, const Mesh& b) {
  return a.facetted == b.facetted && a.positionsMm == b.positionsMm && a.normals == b.normals &&
         a.triangles == b.triangles && a.textureCoordinates == b.textureCoordinates &&
         a.colors == b.colors;
}

bool areSame(const Object& a, const Object& b) {
  return areSame(a.mesh, b.mesh) && materialOf(a) == materialOf(b);
}

// Of each object whether it is one.
std::vector<bool> duplicatesIn(const Scene& scene) {
  std::vector<bool> duplicates(scene.objects.size());
  std::unordered_map<std::uint64_t, std::size_t> firstOf;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (!stays(scene, i)) continue;
    const auto [first, isNew] = firstOf.try_emplace(hashOf(scene.objects[i].mesh), i);
    duplicates[i] = !isNew && areSame(scene.objects[first->second], scene.objects[i]);
  }
  return duplicates;
}

}  // namespace

std::size_t removeDuplicateObjects(Scene& scene) {
  const std::vector<bool> duplicates = duplicatesIn(scene);
  std::vector<Object> kept;
  std::vector<std::uint32_t> indices;  // those that objects have from now on
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    indices.push_back(static_cast<std::uint32_t>(kept.size()));
    if (!duplicates[i]) kept.push_back(std::move(scene.objects[i]));
  }
  const std::size_t count = scene.objects.size() - kept.size();
  scene.objects = std::move(kept);
  for (ClipChanges& changes : scene.changes) {
    for (Keys<OpaqueMaterial>& keys : changes.surfaces) keys.index = indices[keys.index];
    for (Keys<Medium>& keys : changes.media) keys.index = indices[keys.index];
  }
  return count;
}

}  // namespace opaline::scene
