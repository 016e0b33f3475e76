#include "scene/joined_models.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <memory>
#include <string_view>
#include <utility>

#include "scene/not_shown.h"

namespace opaline::scene {

namespace {

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

template <typename T>
void joinKeys(std::vector<Keys<T>>& to, std::vector<Keys<T>>&& added, std::size_t first) {
  for (Keys<T>& keys : added) keys.index += static_cast<std::uint32_t>(first);
  append(to, std::move(added));
}

/// Appends the changes of a model. Its objects and lights follow those of the scene.
void joinChanges(const RawScene& scene, ClipChanges& to, ClipChanges&& added) {
  const Lighting& lighting = scene.lighting;
  joinKeys(to.directional, std::move(added.directional), lighting.directional.size());
  joinKeys(to.points, std::move(added.points), lighting.points.size());
  joinKeys(to.spots, std::move(added.spots), lighting.spots.size());
  joinKeys(to.surfaces, std::move(added.surfaces), scene.objects.size());
  joinKeys(to.media, std::move(added.media), scene.objects.size());
  if (!scene.camera) append(to.cameras, std::move(added.cameras));
}

/// Joins clips before anything else of the model, so that the scene's counts are still the offsets
/// of what will be added.
void joinClips(RawScene& scene, RawScene& model) {
  scene.changes.resize(scene.clips.size());
  model.changes.resize(model.clips.size());
  for (std::size_t c = 0; c < model.clips.size(); ++c) {
    Clip& clip = model.clips[c];
    const auto same = std::find_if(scene.clips.begin(), scene.clips.end(),
                                   [&](const Clip& other) { return other.name == clip.name; });
    const auto at = static_cast<std::size_t>(same - scene.clips.begin());
    if (same == scene.clips.end()) {
      scene.clips.push_back(std::move(clip));
      scene.changes.emplace_back();
    } else {
      same->seconds = std::max(same->seconds, clip.seconds);
      append(same->tracks, std::move(clip.tracks));
    }
    joinChanges(scene, scene.changes[at], std::move(model.changes[c]));
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

/// Objects of one name within a model keep a common name: the file treats them as one.
void JoinedModels::giveOwnNames(RawScene& model) {
  for (RawObject& object : model.objects) {
    const std::string own = object.name;
    if (!names_.contains(own)) continue;
    int& number = numbers_.try_emplace(own, 2).first->second;
    const auto numbered = [&] { return fmt::format("{} {}", own, number); };
    while (names_.contains(numbered())) ++number;
    object.name = numbered();
  }
  for (const RawObject& object : model.objects) names_.insert(object.name);
}

void JoinedModels::add(RawScene&& model) {
  giveOwnNames(model);
  moveNodes(model, static_cast<std::uint32_t>(scene_.nodes.size()));
  joinClips(scene_, model);
  append(scene_.objects, std::move(model.objects));
  append(scene_.nodes, std::move(model.nodes));
  joinLights(scene_, model);
  if (!scene_.camera) {
    scene_.camera = model.camera;
    scene_.cameraChosen = model.cameraChosen;
  }
  addNotShown(scene_.notShown, model.notShown);
  scene_.hasMediaPerMetre = scene_.hasMediaPerMetre || model.hasMediaPerMetre;
  scene_.mmPerUnit = 1.0;
}

LogCallback eachOnce(const LogCallback& log) {
  if (!log) return {};
  return [log, said = std::make_shared<std::set<std::string, std::less<>>>()](
             LogLevel level, std::string_view note) {
    if (said->emplace(note).second) log(level, note);
  };
}

}  // namespace opaline::scene
