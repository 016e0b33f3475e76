#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "environment/suns.h"
#include "opaline/moment.h"
#include "opaline/scene.h"
#include "renderer/motion/scene_motion.h"
#include "renderer/scene/scene_changes.h"
#include "renderer/validate.h"
#include "scene/mesh/merged_mesh.h"

namespace opaline::gpu {
class Device;
}

namespace opaline {

/// The scene that was set, with all its edits. Its counts of changes tell what has to be remade.
/// All functions except set() throw Error while there is no scene.
class EditedScene {
 public:
  EditedScene() = default;
  EditedScene(const EditedScene&) = delete;
  EditedScene& operator=(const EditedScene&) = delete;

  /// Sets a scene at time 0 of its first clip. After an exception there is none.
  void set(gpu::Device& device, const Scene& scene);
  /// How often a scene was set.
  std::uint64_t number() const { return number_; }

  /// The scene. Its meshes are relative to origin(), which is near them; its lights and camera are
  /// as they were given.
  const Scene& scene() const;
  const Vec3& origin() const { return origin_; }
  /// A camera of the caller's, relative to the origin.
  Camera seen(Camera camera) const;
  /// The lights at the current time, relative to the origin. Suns are lights of their own and
  /// removed from the environment.
  const Lighting& lighting() const;
  /// The camera at the current time, relative to the origin.
  const Camera& camera() const;
  const std::vector<DirectionalLight>& suns() const;
  const Object& object(std::size_t index) const;
  const scene::MergedMesh& merged() const { return merged_; }
  SceneMotion& motion();
  /// Counts of the scene's changes, without those of its resources on a device.
  const SceneChanges& changes() const { return changes_; }

  void setCamera(const Camera& camera);
  void setLighting(const Lighting& lighting);
  void setMedium(std::size_t object, const Medium& medium);
  void setMaterial(std::size_t object, const Material& material);
  void setDeformers(const std::vector<Deformer>& deformers);
  /// `partsMove`: they may move parts of the object apart.
  template <typename Positions>
  void replacePositions(std::size_t object, const Positions& positions, bool partsMove = true) {
    motion().given().give(object, positions, motion().tables());
    if (partsMove)
      withMovingParts_.insert(object);
    else
      withMovingParts_.erase(object);
    ++changes_.pose;
  }
  void restorePositions(std::size_t object);
  /// Whether any given positions may have moved parts of an object apart.
  bool partsMove() const { return !withMovingParts_.empty(); }

  /// Throws UsageError for a clip that the scene does not have.
  void setTime(const SceneTime& time);
  const SceneTime& time() const { return time_; }

  /// Has to be called before a frame is made.
  void beginFrame();
  /// Notes that the surface has been divided anew.
  void noteDivision() { ++changes_.media; }
  /// Notes that resources were made on a device. Returns how often that has happened for all
  /// scenes.
  std::uint64_t noteMaking() { return ++makings_; }

 private:
  Scene& edit();
  /// Completes `all`, the scene's lights at the current time: adds the suns of the environment and
  /// removes lights that the ground hides.
  void addSuns(const Lighting& given, const Suns& suns, Lighting& all) const;
  bool movesWithTime() const;
  void followClip();
  void followMaterial(std::size_t object);

  std::uint64_t number_ = 0;
  std::uint64_t makings_ = 0;
  std::optional<Scene> scene_;
  // Clips change what is as it was set.
  Lighting lightingAsSet_;  // without the environment
  MaterialClips materialClips_;
  Vec3 origin_{};
  Suns suns_;
  Lighting lighting_;
  // Kept from the last change to reuse their memory.
  Lighting nextGiven_;
  Lighting next_;
  Camera camera_;
  scene::MergedMesh merged_;
  std::optional<SceneMotion> motion_;
  SceneChanges changes_;
  SceneTime time_;
  std::set<std::size_t> withMovingParts_;  // objects
};

}  // namespace opaline
