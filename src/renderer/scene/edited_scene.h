#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "environment/suns.h"
#include "opaline/scene.h"
#include "renderer/motion/scene_motion.h"
#include "renderer/scene/scene_changes.h"
#include "renderer/validate.h"
#include "scene/mesh/merged_mesh.h"

namespace opaline::gpu {
class Device;
}

namespace opaline {

/// The scene that was set, as its edits have left it. Whoever makes something of it sees by its
/// changes what to make again. Everything but set() throws Error while there is none.
class EditedScene {
 public:
  EditedScene() = default;
  EditedScene(const EditedScene&) = delete;
  EditedScene& operator=(const EditedScene&) = delete;

  /// At time 0 of its first clip. After an exception there is none.
  void set(gpu::Device& device, const Scene& scene);
  /// How often one was set.
  std::uint64_t number() const { return number_; }

  /// Its meshes as from its origin, which is nearer to them than they were given; its lights and
  /// its camera as they were given.
  const Scene& scene() const;
  const Vec3& origin() const { return origin_; }
  /// A camera of the caller's, as from there.
  Camera seen(Camera camera) const;
  /// Its lights as the clip has them and the suns of its environment, which then lacks them; as
  /// from the origin.
  const Lighting& lighting() const;
  /// Where the clip has it, as from the origin.
  const Camera& camera() const;
  const std::vector<DirectionalLight>& suns() const;
  const Object& object(std::size_t index) const;
  const scene::MergedMesh& merged() const { return merged_; }
  SceneMotion& motion();
  /// All but what devices have of it.
  const SceneChanges& changes() const { return changes_; }

  void setCamera(const Camera& camera);
  void setLighting(const Lighting& lighting);
  void setMedium(std::size_t object, const Medium& medium);
  void setMaterial(std::size_t object, const Material& material);
  void setDeformers(const std::vector<Deformer>& deformers);
  template <typename Positions>
  void replacePositions(std::size_t object, const Positions& positions) {
    motion().given().give(object, positions, motion().tables());
    ++changes_.pose;
  }
  void restorePositions(std::size_t object);

  /// Throws UsageError for a clip that it does not have.
  void setTime(const SceneTime& time);
  const SceneTime& time() const { return time_; }

  /// A frame will be made of it.
  void beginFrame();
  /// Its surface has been divided anew.
  void noteDivision() { ++changes_.media; }
  /// A device has it anew. Returns how often that was, for any.
  std::uint64_t noteMaking() { return ++makings_; }

 private:
  Scene& edit();
  /// `all`: as the clip has those that are the scene's, with the suns of the environment, and
  /// without what the ground hides.
  void addSuns(const Lighting& given, const Suns& suns, Lighting& all) const;
  bool movesWithTime() const;
  void followClip();

  std::uint64_t number_ = 0;
  std::uint64_t makings_ = 0;
  std::optional<Scene> scene_;
  Vec3 origin_{};
  Suns suns_;
  Lighting lighting_;
  // Of the last change, for their memory.
  Lighting nextGiven_;
  Lighting next_;
  Camera camera_;
  scene::MergedMesh merged_;
  std::optional<SceneMotion> motion_;
  SceneChanges changes_;
  SceneTime time_;
};

}  // namespace opaline
