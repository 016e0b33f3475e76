#include "renderer/motion/given_positions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "gpu/device.h"
#include "opaline/error.h"
#include "renderer/scene/scene_origin.h"
#include "renderer/validate.h"
#include "scene/finish.h"

namespace opaline {

namespace {

constexpr std::size_t bytesPerPosition = sizeof(Vec3);

// As usable() in deform/vertices.comp.glsl. False for NaN.
bool isNear(const Vec3& positionMm, const Vec3& middleMm) {
  bool near = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
    near = near && std::abs(positionMm[axis] - middleMm[axis]) < scene::longestDiagonalMm;
  return near;
}

}  // namespace

GivenPositions::GivenPositions(gpu::Device& device, std::vector<ObjectRange> ranges,
                               const Vec3& originMm, const Vec3& middleMm)
    : device_(device),
      ranges_(std::move(ranges)),
      origin_(originMm),
      middle_(middleMm),
      objects_(ranges_.size()) {
  if (!ranges_.empty()) vertices_ = ranges_.back().firstVertex + ranges_.back().vertexCount;
}

GivenPositions::Given& GivenPositions::at(std::size_t object) {
  requireObject(object, objects_.size());
  return objects_[object];
}

std::size_t GivenPositions::stagingOffset(std::size_t object) const {
  return (slice_ * vertices_ + ranges_[object].firstVertex) * bytesPerPosition;
}

void GivenPositions::makeRoom(passes::Motion& motion) {
  if (hasRoom_) return;
  motion.replaced = gpu::Buffer(device_, {.name = "given positions",
                                          .bytes = vertices_ * bytesPerPosition,
                                          .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
  hasRoom_ = true;
}

void GivenPositions::give(std::size_t object, std::span<const Vec3> positionsMm,
                          passes::Motion& motion) {
  Given& given = at(object);
  if (positionsMm.size() != ranges_[object].vertexCount)
    throw UsageError(fmt::format("object {} has {} vertices, but {} positions are given", object,
                                 ranges_[object].vertexCount, positionsMm.size()));
  const auto isUsable = [&](Vec3 position) {
    seeFrom(origin_, position);
    return isNear(position, middle_);
  };
  const auto bad = std::find_if_not(positionsMm.begin(), positionsMm.end(), isUsable);
  if (bad != positionsMm.end())
    throw UsageError(
        fmt::format("the position given for vertex {} of object {} is not finite, or not within "
                    "{:.3g} mm of the scene's middle",
                    bad - positionsMm.begin(), object, scene::longestDiagonalMm));
  makeRoom(motion);
  if (!staging_)
    staging_ = gpu::Buffer(device_, {.name = "given positions (staging)",
                                     .bytes = slices * vertices_ * bytesPerPosition,
                                     .memory = gpu::Memory::Upload});
  device_.waitFor(submissions_[slice_]);
  std::byte* to = staging_.mapped().data() + stagingOffset(object);
  for (Vec3 position : positionsMm) {
    seeFrom(origin_, position);
    std::memcpy(to, position.data(), bytesPerPosition);
    to += bytesPerPosition;
  }
  given.source = Source::Host;
  given.pending = true;
}

void GivenPositions::give(std::size_t object, const DevicePositions& positions,
                          passes::Motion& motion) {
  Given& given = at(object);
  constexpr std::uint32_t leastStride = 12;
  if (positions.buffer == VK_NULL_HANDLE)
    throw UsageError(fmt::format("the positions for object {} need a buffer", object));
  if (positions.offsetBytes % 4 != 0 || positions.strideBytes % 4 != 0 ||
      positions.strideBytes < leastStride)
    throw UsageError(fmt::format(
        "the buffer of positions for object {} needs an offset and a stride that are multiples of "
        "4 bytes, and a stride of at least 12",
        object));
  const std::size_t steps = std::max(ranges_[object].vertexCount, 1U) - 1;
  const std::size_t ownBytes = positions.strideBytes * steps + bytesPerPosition;
  const std::size_t limit = device_.limits().maxStorageBufferRange;
  if (ownBytes > limit || positions.offsetBytes > limit - ownBytes)
    throw UsageError(fmt::format(
        "the positions for object {} are {} bytes from byte {} on, but {} reads at most {} from "
        "one buffer",
        object, ownBytes, positions.offsetBytes, device_.info().name, limit));
  const std::size_t bytes = positions.offsetBytes + ownBytes;
  makeRoom(motion);
  given.source = Source::Device;
  given.buffer = gpu::Buffer::borrowed(positions.buffer, bytes);
  given.offset = static_cast<std::uint32_t>(positions.offsetBytes / 4);
  given.stride = positions.strideBytes / 4;
  given.live = positions.live;
}

void GivenPositions::restore(std::size_t object) {
  at(object).source = Source::Pose;
}

bool GivenPositions::readsDevice() const {
  return std::any_of(objects_.begin(), objects_.end(), [](const Given& given) {
    return given.source == Source::Device && given.live;
  });
}

void GivenPositions::record(gpu::CommandList& commands, const passes::DeformPass& pass,
                            passes::Motion& motion) {
  bool copied = false;
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    Given& given = objects_[i];
    given.copied = false;
    const ObjectRange& range = ranges_[i];
    if (range.vertexCount == 0) continue;
    if (given.source == Source::Host && given.pending) {
      commands.copyBuffer(staging_, motion.replaced, range.vertexCount * bytesPerPosition,
                          stagingOffset(i), range.firstVertex * bytesPerPosition);
      given.pending = false;
      given.copied = copied = true;
    } else if (given.source == Source::Device) {
      pass.replace(commands, given.buffer, given.offset, given.stride, range.firstVertex,
                   range.vertexCount, origin_, motion);
    }
  }
  if (!copied) return;
  submissions_[slice_] = device_.submitted() + 1;
  slice_ = (slice_ + 1) % slices;
}

void GivenPositions::abandon() {
  const std::size_t last = (slice_ + slices - 1) % slices;
  if (submissions_[last] <= device_.submitted())
    return;  // nothing was copied, or the copy was
             // submitted
  for (Given& given : objects_) given.pending = given.pending || given.copied;
  slice_ = last;
  submissions_[last] = device_.submitted();
}

}  // namespace opaline
