#pragma once

#include <cstddef>
#include <optional>

#include "opaline/scene.h"

namespace opaline::scene {

/// What a clip changes; null where that is nothing, or where it is none (-1).
const ClipChanges* changesOf(const Scene& scene, int clip);

/// Writes what the keys say at a time of their clip, as clipTime() has it, into something that is
/// like their values but for the numbers. These allocate nothing.
void takeAt(const Keys<DirectionalLight>& keys, double seconds, DirectionalLight& light);
void takeAt(const Keys<PointLight>& keys, double seconds, PointLight& light);
void takeAt(const Keys<SpotLight>& keys, double seconds, SpotLight& light);
void takeAt(const Keys<Camera>& keys, double seconds, Camera& camera);
void takeAt(const Keys<OpaqueMaterial>& keys, double seconds, OpaqueMaterial& material);
void takeAt(const Keys<Medium>& keys, double seconds, Medium& medium);

/// The same of all lights, as far as they are those of the scene, and of the camera, at a time of
/// the scene.
void takeLightsAt(const Scene& scene, const SceneTime& time, Lighting& lighting);
void takeCameraAt(const Scene& scene, const SceneTime& time, Camera& camera);

/// What an object is made of at a time of the scene.
Medium mediumAt(const Scene& scene, std::size_t object, const SceneTime& time);
std::optional<OpaqueMaterial> opaqueAt(const Scene& scene, std::size_t object,
                                       const SceneTime& time);

/// Whether a clip changes what an object is made of.
bool changesMaterial(const Scene& scene, std::size_t object);

/// Whether an opaque object lets light through in some clip, or as it stands.
bool letsLightThrough(const Scene& scene, std::size_t object);

/// Of all that an object is made of in any clip, as it stands too, that with the shortest mean free
/// path: the surface is divided for that.
const Medium& finestMedium(const Scene& scene, std::size_t object);

/// Calls that for each medium that a clip gives an object.
template <typename Visit>
void forEachMediumOf(const Scene& scene, std::size_t object, const Visit& visit) {
  for (const ClipChanges& changes : scene.changes)
    for (const Keys<Medium>& keys : changes.media)
      if (keys.index == object)
        for (const Medium& medium : keys.values) visit(medium);
}

/// An object that somebody makes of something else stays so.
void forgetMaterial(std::vector<ClipChanges>& changes, std::size_t object);

}  // namespace opaline::scene
