#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <optional>

namespace opaline::gpu {

/// What a command does with a resource. All barriers are derived from these.
enum class Access {
  None,                  ///< contents are not needed any more
  ColorWrite,            ///< colour attachment, written and blended
  DepthWrite,            ///< depth attachment, tested and written
  DepthTest,             ///< depth attachment, tested only
  Sampled,               ///< read through a sampler or texelFetch, any shader stage
  StorageRead,           ///< storage image or buffer read, any shader stage
  StorageWrite,          ///< storage image or buffer written or read and written, any shader stage
  Uniform,               ///< uniform buffer
  Index,                 ///< index buffer
  Indirect,              ///< holds the sizes of dispatches
  StorageWriteIndirect,  ///< holds the size of the dispatch that writes it
  Lent,  ///< buffer that the caller reads: in shaders, by copies, or as vertex attributes
  TransferRead,
  TransferWrite,
  RayBuild,  ///< acceleration structure built or refitted, or what building it needs
  RayInput,  ///< triangles that an acceleration structure is built of
  RayQuery,  ///< acceleration structure that shaders send rays through
  HostRead,  ///< by the host, once the submission has finished; nothing writes there before
};

struct AccessScope {
  VkPipelineStageFlags2 stages = 0;
  VkAccessFlags2 accesses = 0;
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;  ///< of images; buffers have none
  bool writes = false;
};

AccessScope scopeOf(Access access);

/// Two accesses by one command. They must agree on the layout.
AccessScope together(const AccessScope& a, const AccessScope& b);

/// What has been recorded for a resource so far: its last write and the reads that see it.
struct AccessState {
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
  VkPipelineStageFlags2 writeStages = 0;
  VkAccessFlags2 writeAccesses = 0;
  VkPipelineStageFlags2 readStages = 0;
  VkAccessFlags2 readAccesses = 0;
  bool isPrepared = false;    ///< the last write has been ordered, and is yet to be recorded
  std::uint64_t command = 0;  ///< number of the last that accessed it; of buffers
};

struct AccessBarrier {
  VkPipelineStageFlags2 fromStages = 0;
  VkAccessFlags2 fromAccesses = 0;
  VkPipelineStageFlags2 toStages = 0;
  VkAccessFlags2 toAccesses = 0;
  VkImageLayout oldLayout = VK_IMAGE_LAYOUT_UNDEFINED;
  VkImageLayout newLayout = VK_IMAGE_LAYOUT_UNDEFINED;

  bool operator==(const AccessBarrier&) const = default;
};

/// Widens a barrier between some accesses of shaders to buffers to one between all.
void widen(AccessBarrier& barrier);

/// Numbers commands in the order in which they are recorded. It knows the last command before which
/// a barrier ordered all earlier accesses of shaders to buffers, which need no other barrier.
class CommandOrder {
 public:
  /// The number of the next command.
  std::uint64_t next() const { return next_; }
  void noteCommand() { ++next_; }
  /// Notes a barrier before the next command.
  void note(const AccessBarrier& barrier);
  /// Whether an earlier barrier already orders this, for a buffer that `command` accessed last.
  bool hasOrdered(const AccessBarrier& barrier, std::uint64_t command) const;

 private:
  std::uint64_t next_ = 1;
  std::uint64_t ordered_ = 0;  // the last command before which a barrier ordered all accesses of
                               // shaders
};

/// Moves `state` on to the next access and returns the barrier that has to stand before it, if any.
/// For a buffer `next.layout` is VK_IMAGE_LAYOUT_UNDEFINED.
std::optional<AccessBarrier> advance(AccessState& state, const AccessScope& next);

/// The same for a write that follows later, with no other access between. When it comes, advance()
/// has no barrier for it.
std::optional<AccessBarrier> prepare(AccessState& state, const AccessScope& next);

}  // namespace opaline::gpu
