#include "scene/joined_models.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include "scene/not_shown.h"

namespace opaline::scene {

namespace {

/// Objects of one name in one model stay so: they are meant together.
void giveOwnNames(RawScene& model, const RawScene& scene) {
  std::set<std::string> taken;
  for (const RawObject& object : scene.objects) taken.insert(object.name);
  for (RawObject& object : model.objects) {
    const std::string own = object.name;
    for (int number = 2; taken.contains(object.name); ++number) {
      object.name = fmt::format("{} {}", own, number);
    }
  }
}

void moveNodes(RawScene& model, std::uint32_t first) {
  for (Node& node : model.nodes) {
    if (node.parent >= 0) node.parent += static_cast<int>(first);
  }
  for (Clip& clip : model.clips) {
    for (Track& track : clip.tracks) track.node += first;
  }
  for (RawObject& object : model.objects) {
    if (!object.rig) continue;
    object.rig->node += first;
    for (Joint& joint : object.rig->joints) joint.node += first;
  }
}

template <typename T>
void append(std::vector<T>& to, std::vector<T>&& added) {
  to.insert(to.end(), std::make_move_iterator(added.begin()), std::make_move_iterator(added.end()));
}

void joinClips(std::vector<Clip>& clips, std::vector<Clip>&& added) {
  for (Clip& clip : added) {
    const auto same = std::find_if(clips.begin(), clips.end(),
                                   [&](const Clip& other) { return other.name == clip.name; });
    if (same == clips.end()) {
      clips.push_back(std::move(clip));
      continue;
    }
    same->seconds = std::max(same->seconds, clip.seconds);
    append(same->tracks, std::move(clip.tracks));
  }
}

void joinLights(RawScene& scene, RawScene& model) {
  if (!model.hasLights) return;
  scene.hasLights = true;
  append(scene.lighting.directional, std::move(model.lighting.directional));
  append(scene.lighting.points, std::move(model.lighting.points));
  append(scene.lighting.spots, std::move(model.lighting.spots));
  append(scene.lighting.areas, std::move(model.lighting.areas));
  for (std::size_t c = 0; c < 3; ++c) scene.lighting.ambient[c] += model.lighting.ambient[c];
}

}  // namespace

void join(RawScene& scene, RawScene&& model) {
  giveOwnNames(model, scene);
  moveNodes(model, static_cast<std::uint32_t>(scene.nodes.size()));
  append(scene.objects, std::move(model.objects));
  append(scene.nodes, std::move(model.nodes));
  joinClips(scene.clips, std::move(model.clips));
  joinLights(scene, model);
  if (!scene.camera) {
    scene.camera = model.camera;
    scene.cameraChosen = model.cameraChosen;
  }
  addNotShown(scene.notShown, model.notShown);
  scene.mmPerUnit = 1.0;
}

}  // namespace opaline::scene
