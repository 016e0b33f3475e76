#include "renderer/scene/edited_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "deform/deformed_vertices.h"
#include "environment/sky.h"
#include "gpu/device.h"
#include "opaline/error.h"
#include "renderer/motion/material_motion.h"
#include "renderer/scene/scene_origin.h"
#include "scene/changes.h"

namespace opaline {

namespace {

// Removes lights below the ground, which shadow maps do not contain. Area lights stay: their rays
// meet the ground.
void hideBelow(float heightMm, Lighting& lighting) {
  const auto isBelow = [&](const auto& light) { return light.positionMm[1] <= heightMm; };
  std::erase_if(lighting.directional,
                [](const DirectionalLight& light) { return light.directionToLight[1] <= 0; });
  std::erase_if(lighting.points, isBelow);
  std::erase_if(lighting.spots, isBelow);
}

}  // namespace

void EditedScene::set(gpu::Device& device, const Scene& scene) {
  ++number_;
  time_ = {};
  withMovingParts_.clear();
  motion_.reset();
  scene_.reset();  // freed before memory for the next is allocated
  scene_ = scene;
  lightingAsSet_ = scene.lighting;
  lightingAsSet_.environment.reset();
  try {
    materialClips_ = MaterialClips(scene);
    origin_ = originFor(*scene_);
    for (Object& object : scene_->objects) seeFrom(origin_, object.mesh);
    merged_ = scene::mergedMesh(*scene_);
    motion_.emplace(device, *scene_, merged_, origin_);
    suns_ = findSuns(scene_->lighting.environment);
    followClip();
  } catch (...) {
    scene_.reset();  // drops an incomplete scene
    throw;
  }
}

const Scene& EditedScene::scene() const {
  if (!scene_) throw Error("no scene is set; call setScene first");
  return *scene_;
}

const Lighting& EditedScene::lighting() const {
  scene();
  return lighting_;
}

const std::vector<DirectionalLight>& EditedScene::suns() const {
  scene();
  return suns_.lights;
}

const Camera& EditedScene::camera() const {
  scene();
  return camera_;
}

// Whether vertices or materials change with time, not only lights and camera.
bool EditedScene::movesWithTime() const {
  const auto hangsOnNodes = [](const Object& object) { return object.rig.has_value(); };
  return !scene_->deformers.empty() || MaterialMotion::isNeeded(*scene_) ||
         std::any_of(scene_->objects.begin(), scene_->objects.end(), hangsOnNodes);
}

void EditedScene::followClip() {
  addSuns(scene_->lighting, suns_, next_);
  if (next_ != lighting_) ++changes_.lights;
  std::swap(lighting_, next_);
  next_.environment.reset();
  camera_ = scene_->camera;
  scene::takeCameraAt(*scene_, time_, camera_);
  seeFrom(origin_, camera_);
}

void EditedScene::addSuns(const Lighting& given, const Suns& suns, Lighting& all) const {
  all = given;
  scene::takeLightsAt(*scene_, lightingAsSet_, given, time_, all);
  seeFrom(origin_, all);
  separate(suns, all);
  if (const Object* ground = groundOf(*scene_)) hideBelow(ground->mesh.positionsMm[0][1], all);
}

Scene& EditedScene::edit() {
  scene();
  return *scene_;
}

const Object& EditedScene::object(std::size_t index) const {
  requireObject(index, scene().objects.size());
  return scene_->objects[index];
}

SceneMotion& EditedScene::motion() {
  scene();
  return *motion_;
}

Camera EditedScene::seen(Camera camera) const {
  seeFrom(origin_, camera);
  return camera;
}

void EditedScene::setCamera(const Camera& camera) {
  validate(camera);
  Camera& present = edit().camera;
  if (camera != present) stopCamera(*scene_);
  present = camera;
  followClip();
}

void EditedScene::setLighting(const Lighting& lighting) {
  validate(lighting);
  Lighting& present = edit().lighting;
  // All that can fail comes first. Suns are only searched in a new environment, because that takes
  // long.
  std::optional<Suns> suns;
  if (lighting.environment != present.environment) suns = findSuns(lighting.environment);
  nextGiven_ = lighting;
  addSuns(nextGiven_, suns ? *suns : suns_, next_);
  ++changes_.lights;
  if (!sameSky(lighting, present)) ++changes_.sky;
  if (suns) suns_ = *std::move(suns);
  std::swap(lighting_, next_);
  std::swap(present, nextGiven_);
  nextGiven_.environment.reset();
  next_.environment.reset();
}

void EditedScene::setMedium(std::size_t object, const Medium& medium) {
  validate(medium);
  requireObject(object, scene().objects.size());
  Medium given = medium;
  edit().objects[object].medium = std::move(given);
  followMaterial(object);
}

void EditedScene::setMaterial(std::size_t object, const Material& material) {
  requireObject(object, scene().objects.size());
  const Object& present = scene().objects[object];
  if (present.opaque.has_value() != material.opaque.has_value())
    throw UsageError(fmt::format("object '{}' is {} and stays so: setScene() takes another",
                                 present.name, present.opaque ? "opaque" : "translucent"));
  validate(present.name, material);
  giveMaterial(material, edit().objects[object]);
  followMaterial(object);
}

void EditedScene::followMaterial(std::size_t object) {
  ++changes_.media;
  materialClips_.follow(object, *scene_);
}

void EditedScene::setDeformers(const std::vector<Deformer>& deformers) {
  validate(deformers);
  edit().deformers = deformers;
  ++changes_.pose;
}

void EditedScene::restorePositions(std::size_t object) {
  motion().given().restore(object);
  withMovingParts_.erase(object);
  ++changes_.pose;
}

void EditedScene::setTime(const SceneTime& time) {
  deform::requireTime(scene(), time);
  if (time == time_) return;
  time_ = time;
  if (movesWithTime()) ++changes_.pose;
  if (!scene_->changes.empty()) followClip();
}

void EditedScene::beginFrame() {
  if (motion().given().readsDevice()) ++changes_.pose;
}

}  // namespace opaline
