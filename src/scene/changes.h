#pragma once

#include <cstddef>
#include <optional>

#include "opaline/scene.h"

namespace opaline::scene {

/// What a clip changes. Null where it changes nothing, or where there is no clip (-1).
const ClipChanges* changesOf(const Scene& scene, int clip);

/// Each writes what the keys say at a time of their clip, as clipTime() gives it, into a value that
/// matches theirs in all but the numbers. None allocates.
void takeAt(const Keys<DirectionalLight>& keys, double seconds, DirectionalLight& light);
void takeAt(const Keys<PointLight>& keys, double seconds, PointLight& light);
void takeAt(const Keys<SpotLight>& keys, double seconds, SpotLight& light);
void takeAt(const Keys<Camera>& keys, double seconds, Camera& camera);
void takeAt(const Keys<OpaqueMaterial>& keys, double seconds, OpaqueMaterial& material);
void takeAt(const Keys<Medium>& keys, double seconds, Medium& medium);

/// The same for all of the scene's own lights, and for its camera, at a time of the scene.
void takeLightsAt(const Scene& scene, const SceneTime& time, Lighting& lighting);
/// The same for lights of which only those follow clips that equal the scene's `own`, wherever they
/// stand among those `given`. `lighting` begins with them.
void takeLightsAt(const Scene& scene, const Lighting& own, const Lighting& given,
                  const SceneTime& time, Lighting& lighting);
void takeCameraAt(const Scene& scene, const SceneTime& time, Camera& camera);

/// What an object is made of at a time of the scene.
Medium mediumAt(const Scene& scene, std::size_t object, const SceneTime& time);
std::optional<OpaqueMaterial> opaqueAt(const Scene& scene, std::size_t object,
                                       const SceneTime& time);

/// Whether a clip changes what an object is made of.
bool changesMaterial(const Scene& scene, std::size_t object);

/// Whether an opaque object lets light through in some clip, or as it stands.
bool letsLightThrough(const Scene& scene, std::size_t object);

/// The medium with the shortest mean free path among all that an object is made of, at rest and in
/// any clip. The surface is divided finely enough for it.
const Medium& finestMedium(const Scene& scene, std::size_t object);

/// Calls `visit` for each medium that a clip gives an object.
template <typename Visit>
void forEachMediumOf(const Scene& scene, std::size_t object, const Visit& visit) {
  for (const ClipChanges& changes : scene.changes)
    for (const Keys<Medium>& keys : changes.media)
      if (keys.index == object)
        for (const Medium& medium : keys.values) visit(medium);
}

/// Drops what clips do to an object's material, once somebody has given the object another.
void forgetMaterial(std::vector<ClipChanges>& changes, std::size_t object);

}  // namespace opaline::scene
