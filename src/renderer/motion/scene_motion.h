#pragma once

#include <cstddef>
#include <vector>

#include "gpu/command_list.h"
#include "gpu/transfer.h"
#include "opaline/scene.h"
#include "passes/deform/deform_pass.h"
#include "passes/products.h"
#include "renderer/motion/given_positions.h"
#include "renderer/motion/motion_tables.h"
#include "scene/pose.h"
#include "shaders/shared/deform.h"

namespace opaline {

/// The motion of a scene on the device. The host only evaluates the pose of its nodes for every
/// frame; the device does the rest. The scene outlives it, and its deformers may change. The scene
/// has been moved to that origin, except for its nodes and the positions that callers give.
class SceneMotion {
 public:
  SceneMotion(gpu::Device& device, const Scene& scene, const scene::MergedMesh& merged,
              const Vec3& originMm);

  /// Moves `mesh` to its shape at that time; allocates nothing.
  void record(gpu::CommandList& commands, const passes::DeformPass& pass, const SceneTime& time,
              passes::DeformedMesh& mesh);

  const std::vector<ObjectRange>& ranges() const { return ranges_; }
  /// Notes that a frame was abandoned.
  void abandon() { given_.abandon(); }

  GivenPositions& given() { return given_; }
  passes::Motion& tables() { return motion_; }

 private:
  void fillFrame(double seconds);
  void fillPose(const SceneTime& time);
  void upload(gpu::CommandList& commands);

  const Scene& scene_;
  Vec3 origin_;
  std::vector<ObjectRange> ranges_;
  passes::Motion motion_;
  GivenPositions given_;
  scene::Pose pose_;
  std::vector<scene::Matrix4> joints_;  // of one object
  std::vector<bool> restMirrors_;       // by object
  bool hasHeight_ = false;              // else deformers do nothing
  // What is uploaded for a frame.
  shared::DeformFrame frame_{};
  std::vector<float> weights_;
  std::vector<shared::vec4> matrices_;
  std::vector<shared::ObjectMotion> objects_;
  gpu::UploadRing ring_;
};

}  // namespace opaline
