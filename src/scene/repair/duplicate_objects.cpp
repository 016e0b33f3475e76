#include "scene/repair/duplicate_objects.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "scene/hash.h"

namespace opaline::scene {

namespace {

/// Each object is compared with this many others of the same hash. Those of one mesh and medium can
/// only differ in their textures.
constexpr std::size_t mostCompared = 16;

std::vector<bool> changingIn(const Scene& scene) {
  std::vector<bool> changing(scene.objects.size());
  for (std::size_t i = 0; i < changing.size(); ++i) changing[i] = scene.objects[i].rig.has_value();
  for (const ClipChanges& changes : scene.changes) {
    for (const Keys<OpaqueMaterial>& keys : changes.surfaces) changing.at(keys.index) = true;
    for (const Keys<Medium>& keys : changes.media) changing.at(keys.index) = true;
  }
  return changing;
}

std::uint64_t hashOf(const Object& object) {
  std::uint64_t hash = object.mesh.triangles.size();
  for (const Vec3& position : object.mesh.positionsMm)
    for (const float coordinate : position) mix(hash, std::bit_cast<std::uint32_t>(coordinate));
  for (const Triangle& triangle : object.mesh.triangles)
    for (const std::uint32_t vertex : triangle) mix(hash, vertex);
  const Medium& medium = object.medium;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    mix(hash, std::bit_cast<std::uint64_t>(medium.sigmaSPrimePerMm[channel]));
    mix(hash, std::bit_cast<std::uint64_t>(medium.sigmaAPerMm[channel]));
  }
  mix(hash, object.opaque.has_value() ? 1 : 0);
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

// For each object the first one that equals it, or itself.
std::vector<std::size_t> originalsIn(const Scene& scene) {
  const std::vector<bool> changing = changingIn(scene);
  std::vector<std::size_t> originals(scene.objects.size());
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> known;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    originals[i] = i;
    if (changing[i]) continue;
    std::vector<std::size_t>& alike = known[hashOf(scene.objects[i])];
    const auto same = std::find_if(alike.begin(), alike.end(), [&](std::size_t other) {
      return areSame(scene.objects[other], scene.objects[i]);
    });
    if (same != alike.end())
      originals[i] = *same;
    else if (alike.size() < mostCompared)
      alike.push_back(i);
  }
  return originals;
}

}  // namespace

std::size_t removeDuplicateObjects(Scene& scene) {
  const std::vector<std::size_t> originals = originalsIn(scene);
  std::vector<Object> kept;
  std::vector<std::uint32_t> indices;  // the new index of each object
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (originals[i] == i) {
      indices.push_back(static_cast<std::uint32_t>(kept.size()));
      kept.push_back(std::move(scene.objects[i]));
    } else {
      indices.push_back(indices[originals[i]]);
      kept[indices[i]].duplicates.push_back(std::move(scene.objects[i].name));
    }
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
