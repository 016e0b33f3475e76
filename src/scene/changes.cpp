#include "scene/changes.h"

#include <cmath>
#include <optional>

#include "bssrdf/profile.h"
#include "opaline/moment.h"
#include "scene/material.h"
#include "scene/pose.h"
#include "scene/track_sample.h"
#include "scene/vector_math.h"

namespace opaline::scene {

namespace {

/// Interpolates between two values of one type, number by number.
struct Blend {
  double t = 0;

  void operator()(float a, float b, float& to) const {
    to = static_cast<float>((1 - t) * double{a} + t * double{b});
  }
  void operator()(double a, double b, double& to) const { to = (1 - t) * a + t * b; }
  template <typename T, std::size_t Count>
  void operator()(const std::array<T, Count>& a, const std::array<T, Count>& b,
                  std::array<T, Count>& to) const {
    for (std::size_t i = 0; i < Count; ++i) (*this)(a[i], b[i], to[i]);
  }

  void direction(const Vec3& a, const Vec3& b, Vec3& to) const {
    const Double3 between = (1 - t) * toDouble(a) + t * toDouble(b);
    const double size = length(between);
    to = size > 0 ? toFloat((1 / size) * between) : a;
  }

  void operator()(const DirectionalLight& a, const DirectionalLight& b,
                  DirectionalLight& to) const {
    direction(a.directionToLight, b.directionToLight, to.directionToLight);
    (*this)(a.irradiance, b.irradiance, to.irradiance);
  }
  void operator()(const PointLight& a, const PointLight& b, PointLight& to) const {
    (*this)(a.positionMm, b.positionMm, to.positionMm);
    (*this)(a.intensity, b.intensity, to.intensity);
  }
  void operator()(const SpotLight& a, const SpotLight& b, SpotLight& to) const {
    (*this)(a.positionMm, b.positionMm, to.positionMm);
    direction(a.direction, b.direction, to.direction);
    (*this)(a.intensity, b.intensity, to.intensity);
    (*this)(a.innerDegrees, b.innerDegrees, to.innerDegrees);
    (*this)(a.outerDegrees, b.outerDegrees, to.outerDegrees);
  }
  void operator()(const Camera& a, const Camera& b, Camera& to) const {
    (*this)(a.positionMm, b.positionMm, to.positionMm);
    (*this)(a.targetMm, b.targetMm, to.targetMm);
    (*this)(a.up, b.up, to.up);
    (*this)(a.verticalFovDegrees, b.verticalFovDegrees, to.verticalFovDegrees);
    if (a.orthographicHeightMm && b.orthographicHeightMm && to.orthographicHeightMm)
      (*this)(*a.orthographicHeightMm, *b.orthographicHeightMm, *to.orthographicHeightMm);
  }
  void operator()(const Medium& a, const Medium& b, Medium& to) const {
    (*this)(a.sigmaSPrimePerMm, b.sigmaSPrimePerMm, to.sigmaSPrimePerMm);
    (*this)(a.sigmaAPerMm, b.sigmaAPerMm, to.sigmaAPerMm);
    (*this)(a.g, b.g, to.g);
  }
  void operator()(const OpaqueMaterial& a, const OpaqueMaterial& b, OpaqueMaterial& to) const {
    (*this)(a.baseColor, b.baseColor, to.baseColor);
    (*this)(a.metallic, b.metallic, to.metallic);
    (*this)(a.roughness, b.roughness, to.roughness);
    (*this)(a.ior, b.ior, to.ior);
    (*this)(a.specular, b.specular, to.specular);
    (*this)(a.specularColor, b.specularColor, to.specularColor);
    (*this)(a.normalScale, b.normalScale, to.normalScale);
    (*this)(a.occlusionStrength, b.occlusionStrength, to.occlusionStrength);
    (*this)(a.emission, b.emission, to.emission);
    (*this)(a.alphaCutoff, b.alphaCutoff, to.alphaCutoff);
    (*this)(a.alpha, b.alpha, to.alpha);
    (*this)(a.diffuseTransmission, b.diffuseTransmission, to.diffuseTransmission);
    (*this)(a.diffuseTransmissionColor, b.diffuseTransmissionColor, to.diffuseTransmissionColor);
    for (const TextureOfMaterial& of : texturesOfMaterial) {
      const auto& from = a.*of.texture;
      const auto& next = b.*of.texture;
      auto& texture = to.*of.texture;
      if (from && next && texture) (*this)(from->transform, next->transform, texture->transform);
    }
  }
};

template <typename T>
void take(const Keys<T>& keys, double seconds, T& to) {
  const KeyPlace place = placeAmong(keys.seconds, seconds);
  Blend{place.t}(keys.values[place.from], keys.values[place.to], to);
}

double timeIn(const Scene& scene, const SceneTime& time) {
  return clipTime(scene.clips[static_cast<std::size_t>(time.clip)], time.seconds);
}

// Where one of the scene's own lights stands among those given: at its index or, if some were
// removed before it, where an equal one is. Nowhere if it was edited.
template <typename T>
std::optional<std::size_t> placeOf(std::size_t index, const std::vector<T>& own,
                                   const std::vector<T>& given) {
  if (index >= own.size()) return std::nullopt;
  const auto isAt = [&](std::size_t i, std::size_t place) {
    return i < own.size() && place < given.size() && given[place] == own[i];
  };
  if (isAt(index, index)) return index;
  for (std::size_t place = 0; place < given.size(); ++place)
    if (isAt(index, place) && !isAt(place, place)) return place;
  return std::nullopt;
}

template <typename T>
void takeAll(const std::vector<Keys<T>>& all, double seconds, const std::vector<T>& own,
             const std::vector<T>& given, std::vector<T>& to) {
  for (const Keys<T>& keys : all)
    if (const auto place = placeOf(keys.index, own, given)) take(keys, seconds, to[*place]);
}

}  // namespace

const ClipChanges* changesOf(const Scene& scene, int clip) {
  const auto index = static_cast<std::size_t>(clip);
  if (clip < 0 || index >= scene.changes.size() || index >= scene.clips.size()) return nullptr;
  return &scene.changes[index];
}

void takeAt(const Keys<DirectionalLight>& keys, double seconds, DirectionalLight& light) {
  take(keys, seconds, light);
}
void takeAt(const Keys<PointLight>& keys, double seconds, PointLight& light) {
  take(keys, seconds, light);
}
void takeAt(const Keys<SpotLight>& keys, double seconds, SpotLight& light) {
  take(keys, seconds, light);
}
void takeAt(const Keys<Camera>& keys, double seconds, Camera& camera) {
  take(keys, seconds, camera);
}
void takeAt(const Keys<OpaqueMaterial>& keys, double seconds, OpaqueMaterial& material) {
  take(keys, seconds, material);
}
void takeAt(const Keys<Medium>& keys, double seconds, Medium& medium) {
  take(keys, seconds, medium);
}

void takeLightsAt(const Scene& scene, const SceneTime& time, Lighting& lighting) {
  takeLightsAt(scene, scene.lighting, scene.lighting, time, lighting);
}

void takeLightsAt(const Scene& scene, const Lighting& own, const Lighting& given,
                  const SceneTime& time, Lighting& lighting) {
  const ClipChanges* const changes = changesOf(scene, time.clip);
  if (changes == nullptr) return;
  const double seconds = timeIn(scene, time);
  takeAll(changes->directional, seconds, own.directional, given.directional, lighting.directional);
  takeAll(changes->points, seconds, own.points, given.points, lighting.points);
  takeAll(changes->spots, seconds, own.spots, given.spots, lighting.spots);
}

void takeCameraAt(const Scene& scene, const SceneTime& time, Camera& camera) {
  const ClipChanges* const changes = changesOf(scene, time.clip);
  if (changes == nullptr || changes->cameras.empty()) return;
  take(changes->cameras.front(), timeIn(scene, time), camera);
}

Medium mediumAt(const Scene& scene, std::size_t object, const SceneTime& time) {
  Medium medium = scene.objects[object].medium;
  if (const ClipChanges* const changes = changesOf(scene, time.clip))
    for (const Keys<Medium>& keys : changes->media)
      if (keys.index == object) take(keys, timeIn(scene, time), medium);
  return medium;
}

std::optional<OpaqueMaterial> opaqueAt(const Scene& scene, std::size_t object,
                                       const SceneTime& time) {
  std::optional<OpaqueMaterial> material = scene.objects[object].opaque;
  const ClipChanges* const changes = changesOf(scene, time.clip);
  if (!material || !changes) return material;
  for (const Keys<OpaqueMaterial>& keys : changes->surfaces)
    if (keys.index == object) take(keys, timeIn(scene, time), *material);
  return material;
}

bool changesMaterial(const Scene& scene, std::size_t object) {
  const auto names = [&](const auto& all) {
    for (const auto& keys : all)
      if (keys.index == object) return true;
    return false;
  };
  for (const ClipChanges& changes : scene.changes)
    if (names(changes.media) || names(changes.surfaces)) return true;
  return false;
}

bool letsLightThrough(const Scene& scene, std::size_t object) {
  const std::optional<OpaqueMaterial>& material = scene.objects[object].opaque;
  if (!material) return false;
  bool any = letsLightThrough(*material);
  for (const ClipChanges& changes : scene.changes)
    for (const Keys<OpaqueMaterial>& keys : changes.surfaces)
      if (keys.index == object)
        for (const OpaqueMaterial& of : keys.values) any = any || letsLightThrough(of);
  return any;
}

const Medium& finestMedium(const Scene& scene, std::size_t object) {
  const Medium* finest = &scene.objects[object].medium;
  forEachMediumOf(scene, object, [&](const Medium& medium) {
    if (bssrdf::shortestMeanFreePathMm(medium) < bssrdf::shortestMeanFreePathMm(*finest))
      finest = &medium;
  });
  return *finest;
}

void forgetMaterial(std::vector<ClipChanges>& changes, std::size_t object) {
  const auto isOf = [&](const auto& keys) { return keys.index == object; };
  for (ClipChanges& of : changes) {
    std::erase_if(of.surfaces, isOf);
    std::erase_if(of.media, isOf);
  }
}

}  // namespace opaline::scene

namespace opaline {

Camera cameraAt(const Scene& scene, const SceneTime& time) {
  Camera camera = scene.camera;
  scene::takeCameraAt(scene, time, camera);
  return camera;
}

bool movesCamera(const Scene& scene, int clip) {
  const ClipChanges* const changes = scene::changesOf(scene, clip);
  return changes != nullptr && !changes->cameras.empty();
}

Lighting lightingAt(const Scene& scene, const SceneTime& time) {
  Lighting lighting = scene.lighting;
  scene::takeLightsAt(scene, time, lighting);
  return lighting;
}

MaterialClips::MaterialClips(const Scene& scene) : changes_(scene.changes) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    if (scene::changesMaterial(scene, i)) materials_[i] = materialOf(scene.objects[i]);
}

void MaterialClips::follow(std::size_t object, Scene& scene) const {
  const auto as = materials_.find(object);
  if (as == materials_.end()) return;
  scene::forgetMaterial(scene.changes, object);
  if (materialOf(scene.objects[object]) != as->second) return;
  const auto recall = [&](const auto& had, auto& has) {
    for (const auto& keys : had)
      if (keys.index == object) has.push_back(keys);
  };
  for (std::size_t clip = 0; clip < changes_.size(); ++clip) {
    recall(changes_[clip].surfaces, scene.changes[clip].surfaces);
    recall(changes_[clip].media, scene.changes[clip].media);
  }
}

void stopLights(Scene& scene) {
  for (ClipChanges& changes : scene.changes) {
    changes.directional.clear();
    changes.points.clear();
    changes.spots.clear();
  }
}

void stopCamera(Scene& scene) {
  for (ClipChanges& changes : scene.changes) changes.cameras.clear();
}

}  // namespace opaline
