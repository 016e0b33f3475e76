#include "renderer/motion/material_motion.h"

#include <algorithm>
#include <span>
#include <utility>

#include "gpu/device.h"
#include "opaline/view.h"
#include "renderer/scene/opaque_tables.h"
#include "scene/changes.h"
#include "scene/pose.h"

namespace opaline {

namespace {

template <typename T>
bool names(const std::vector<Keys<T>>& all, std::size_t object) {
  return std::any_of(all.begin(), all.end(),
                     [&](const Keys<T>& keys) { return keys.index == object; });
}

// Takes the clip's value for an object, if it has one.
template <typename T>
void takeOf(const std::vector<Keys<T>>& all, std::size_t object, double seconds, T& to) {
  for (const Keys<T>& keys : all)
    if (keys.index == object) scene::takeAt(keys, seconds, to);
}

std::size_t bytesOf(const gpu::Device& device, const SceneResources& resources,
                    const TablesOnHost& tables) {
  constexpr std::size_t parts = 3;
  const std::size_t slack =
      std::max<std::size_t>({16, device.limits().minUniformBufferOffsetAlignment,
                             device.limits().minStorageBufferOffsetAlignment});
  return std::span(resources.materialsOnHost).size_bytes() + std::span(tables.media).size_bytes() +
         std::span(tables.objects).size_bytes() + parts * slack;
}

}  // namespace

bool MaterialMotion::isNeeded(const Scene& scene) {
  return std::any_of(scene.changes.begin(), scene.changes.end(), [](const ClipChanges& changes) {
    return !changes.surfaces.empty() || !changes.media.empty();
  });
}

MaterialMotion::MaterialMotion(gpu::Device& device, const Scene& scene,
                               const SceneResources& resources, Transport transport,
                               TablesOnHost onHost)
    : scene_(scene),
      resources_(resources),
      transport_(transport),
      onHost_(std::move(onHost)),
      ring_(device, "materials of a frame", bytesOf(device, resources, onHost_),
            View::framesInFlight, 0) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    bool surface = false;
    bool medium = false;
    for (const ClipChanges& changes : scene.changes) {
      surface = surface || names(changes.surfaces, i);
      medium = medium || names(changes.media, i);
    }
    if (surface && scene.objects[i].opaque) surfaces_.push_back({i, *scene.objects[i].opaque});
    if (medium && !scene.objects[i].opaque) bodies_.push_back(i);
  }
  if (!surfaces_.empty()) materials_ = resources.materialsOnHost;
}

void MaterialMotion::record(gpu::CommandList& commands, const SceneTime& time,
                            passes::OpaqueTables& opaque, passes::SceneTables& tables) {
  const ClipChanges* const changes = scene::changesOf(scene_, time.clip);
  const double seconds =
      changes == nullptr
          ? 0
          : scene::clipTime(scene_.clips[static_cast<std::size_t>(time.clip)], time.seconds);
  for (auto& [object, now] : surfaces_) {
    shared::OpaqueData& data = materials_[resources_.materialOfObject[object]];
    setNumbers(*scene_.objects[object].opaque, data);
    if (changes == nullptr || !names(changes->surfaces, object)) continue;
    takeOf(changes->surfaces, object, seconds, now);
    setNumbers(now, data);
  }
  for (const std::size_t object : bodies_) {
    const Medium& rest = scene_.objects[object].medium;
    Medium now{{}, rest.sigmaSPrimePerMm, rest.sigmaAPerMm, rest.eta, rest.g};
    if (changes != nullptr) takeOf(changes->media, object, seconds, now);
    setMedium(now, transport_, onHost_.media[resources_.mediumOfObject[object]]);
    setMediumOf(resources_, object, now, transport_, onHost_.objects[object]);
  }
  commands.beginPass("materials");
  ring_.nextFrame();
  const auto copy = [&](const auto& data, gpu::Buffer& to) {
    const auto bytes = std::as_bytes(std::span(data));
    commands.copyBuffer(ring_.buffer(), to, bytes.size(), ring_.push(bytes));
  };
  if (!surfaces_.empty()) copy(materials_, opaque.materials);
  if (!bodies_.empty()) {
    copy(onHost_.media, tables.media);
    copy(onHost_.objects, tables.objects);
  }
  commands.endPass();
}

}  // namespace opaline
