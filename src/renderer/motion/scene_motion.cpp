#include "renderer/motion/scene_motion.h"

#include <algorithm>
#include <span>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "deform/deformer.h"
#include "gpu/device.h"
#include "opaline/view.h"
#include "scene/finish.h"

namespace opaline {

namespace {

std::size_t totalWeights(const std::vector<ObjectRange>& ranges) {
  return ranges.empty() ? 0 : ranges.back().firstWeight + ranges.back().weightCount;
}

std::size_t totalMatrices(const std::vector<ObjectRange>& ranges) {
  return ranges.empty() ? 0 : ranges.back().firstMatrix + ranges.back().matrixCount;
}

std::size_t mostJoints(const std::vector<ObjectRange>& ranges) {
  std::size_t most = 0;
  for (const ObjectRange& range : ranges) most = std::max<std::size_t>(most, range.matrixCount);
  return most;
}

// Includes what aligning each part may take.
std::size_t uploadBytes(const gpu::Device& device, const std::vector<ObjectRange>& ranges) {
  const VkPhysicalDeviceLimits& limits = device.limits();
  const std::size_t slack = std::max<std::size_t>(
      {16, limits.minUniformBufferOffsetAlignment, limits.minStorageBufferOffsetAlignment});
  constexpr std::size_t parts = 4;
  return sizeof(shared::DeformFrame) + totalWeights(ranges) * sizeof(float) +
         totalMatrices(ranges) * 3 * sizeof(shared::vec4) +
         ranges.size() * sizeof(shared::ObjectMotion) + parts * slack;
}

void addRows(const scene::Matrix4& matrix, const Vec3& originMm, std::vector<shared::vec4>& rows,
             std::size_t first) {
  for (std::size_t row = 0; row < 3; ++row)
    rows[first + row] = {
        static_cast<float>(matrix.column[0][row]), static_cast<float>(matrix.column[1][row]),
        static_cast<float>(matrix.column[2][row]),
        static_cast<float>(matrix.column[3][row] - static_cast<double>(originMm[row]))};
}

}  // namespace

SceneMotion::SceneMotion(gpu::Device& device, const Scene& scene, const scene::MergedMesh& merged,
                         const Vec3& originMm)
    : scene_(scene),
      origin_(originMm),
      ranges_(rangesOf(scene)),
      motion_(makeMotionTables(device, scene, merged, ranges_)),
      given_(device, ranges_, originMm, middleOf(boundsOf(scene))),
      pose_(scene::makePose(scene)),
      joints_(mostJoints(ranges_)),
      weights_(totalWeights(ranges_)),
      matrices_(3 * totalMatrices(ranges_)),
      objects_(ranges_.size()),
      ring_(device, "motion of a frame", uploadBytes(device, ranges_), View::framesInFlight, 0) {
  for (std::size_t i = 0; i < ranges_.size(); ++i) {
    const std::span<scene::Matrix4> joints(joints_.data(), ranges_[i].matrixCount);
    if (scene.objects[i].rig) scene::jointMatrices(*scene.objects[i].rig, pose_, joints);
    restMirrors_.push_back(scene::mirrors(joints));
  }
  const Bounds bounds = boundsOf(scene);
  const glm::vec3 low = glm::make_vec3(bounds.minMm.data());
  const glm::vec3 high = glm::make_vec3(bounds.maxMm.data());
  const glm::vec3 middle = glm::make_vec3(middleOf(bounds).data());
  frame_.counts = {static_cast<std::uint32_t>(merged.positionsMm.size()), 0,
                   motion_.hasDeltas ? 1 : 0, motion_.hasInfluences ? 1 : 0};
  frame_.middle = {middle, scene::longestDiagonalMm};
  hasHeight_ = high.y > low.y;
  for (shared::DeformerData& data : frame_.deformers) {
    data.box = {middle.x, low.y, middle.z, high.y - low.y};
    data.amount = {0, 0, glm::length(high - low), 0};
  }
}

void SceneMotion::fillFrame(double seconds) {
  frame_.counts.y = hasHeight_ ? static_cast<std::uint32_t>(scene_.deformers.size()) : 0;
  for (std::uint32_t i = 0; i < frame_.counts.y; ++i) {
    shared::DeformerData& data = frame_.deformers[i];
    const Deformer& deformer = scene_.deformers[i];
    data.kind.x = static_cast<std::uint32_t>(deformer.kind);
    data.amount.x = static_cast<float>(deform::amountAt(deformer, seconds));
    data.amount.y = static_cast<float>(deform::wavePhaseAt(deformer, seconds));
  }
  motion_.normalsFromMesh = false;
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    objects_[i].side = 1;
    objects_[i].isGround = scene_.objects[i].isGround ? 1 : 0;
    objects_[i].replaced = given_.isGiven(i) ? 1 : 0;
    objects_[i].normalsFromMesh = given_.isGiven(i) || ranges_[i].normalsFromMesh ? 1 : 0;
    motion_.normalsFromMesh = motion_.normalsFromMesh || objects_[i].normalsFromMesh != 0;
  }
}

void SceneMotion::fillPose(const SceneTime& time) {
  scene::poseAt(scene_, time.clip, time.seconds, pose_);
  for (std::size_t i = 0; i < ranges_.size(); ++i) {
    const std::optional<Rig>& rig = scene_.objects[i].rig;
    if (!rig) continue;
    const ObjectRange& range = ranges_[i];
    const std::span<const float> given = scene::morphWeights(*rig, pose_);
    for (std::size_t t = 0; t < range.weightCount; ++t)
      weights_[range.firstWeight + t] = t < given.size() ? given[t] : 0.0F;
    const std::span<scene::Matrix4> joints(joints_.data(), range.matrixCount);
    scene::jointMatrices(*rig, pose_, joints);
    if (!given_.isGiven(i))
      objects_[i].side = scene::mirrors(joints) == restMirrors_[i] ? 1.0F : -1.0F;
    for (std::size_t j = 0; j < joints.size(); ++j)
      addRows(joints[j], origin_, matrices_, 3 * (range.firstMatrix + j));
  }
}

void SceneMotion::upload(gpu::CommandList& commands) {
  const auto copy = [&](std::span<const std::byte> data, gpu::Buffer& to) {
    const std::size_t offset = data.empty() ? 0 : ring_.push(data);
    return gpu::BufferCopy{&ring_.buffer(), &to, data.size(), offset};
  };
  ring_.nextFrame();
  const gpu::BufferCopy copies[] = {
      copy(std::as_bytes(std::span(&frame_, 1)), motion_.frame),
      copy(std::as_bytes(std::span(std::as_const(weights_))), motion_.weights),
      copy(std::as_bytes(std::span(std::as_const(matrices_))), motion_.matrices),
      copy(std::as_bytes(std::span(std::as_const(objects_))), motion_.objects)};
  commands.copyBuffers(copies);
}

void SceneMotion::record(gpu::CommandList& commands, const passes::DeformPass& pass,
                         const SceneTime& time, passes::DeformedMesh& mesh) {
  fillFrame(time.seconds);
  fillPose(time);
  commands.beginPass("deform");
  upload(commands);
  given_.record(commands, pass, motion_);
  commands.endPass();
  commands.cut();  // given positions may be in another buffer in every frame
  commands.beginPass("deform");
  pass.record(commands, motion_, mesh);
  commands.endPass();
}

}  // namespace opaline
