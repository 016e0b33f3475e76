#pragma once

#include <vulkan/vulkan.h>

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "gpu/access.h"
#include "gpu/binding.h"
#include "gpu/buffer.h"
#include "gpu/command_tape.h"
#include "gpu/device.h"
#include "gpu/image.h"
#include "gpu/pass_timer.h"
#include "gpu/pipeline.h"

namespace opaline::gpu {

class AccelerationStructure;

struct ColorTarget {
  GpuImage* image = nullptr;
  std::uint32_t layer = 0;
  bool clear = true;  ///< else the contents are kept
  float clearValue[4] = {0, 0, 0, 0};
};

struct DepthTarget {
  GpuImage* image = nullptr;
  std::uint32_t layer = 0;
  bool clear = true;
  float clearValue = 0.0F;  ///< reversed depth: 0 is far
  bool write = true;
};

struct BufferCopy {
  Buffer* from = nullptr;
  Buffer* to = nullptr;
  std::size_t bytes = 0;
  std::size_t fromOffset = 0;
  std::size_t toOffset = 0;
};

/// Counts of commands.
struct CommandCounts {
  std::uint32_t dispatches = 0;
  std::uint32_t barriers = 0;
  std::uint32_t recordings = 0;  ///< of parts of the list; parts that are kept need none
};

/// Takes commands, orders accesses, submits and waits. A list is reused for every frame: after the
/// first frames it allocates nothing, and a part whose commands have not changed since its last
/// submission is not recorded again. Resources are bound before the beginRendering() of the draw
/// that uses them, because barriers cannot stand inside a rendering scope; bindings stay valid
/// inside it. Resources remember their last access across lists, so lists have to be submitted, in
/// the order in which they were filled. The destructor waits for the device.
class CommandList {
 public:
  CommandList(Device& device, std::string name, std::uint32_t maxPasses = 64);
  ~CommandList();
  CommandList(const CommandList&) = delete;
  CommandList& operator=(const CommandList&) = delete;

  /// Waits until the last submission has finished, then starts an empty list.
  void begin();
  /// Ends a part of the list, between passes, to separate commands that change from frame to frame
  /// from those that do not. Afterwards nothing is bound.
  void cut();
  /// Submits everything to the queue, after `waits` and before `signals`; does not wait.
  void submit(std::span<const SemaphoreValue> waits = {},
              std::span<const SemaphoreValue> signals = {});
  /// Records everything into a primary command buffer of the caller's. The caller submits it to the
  /// same queue before any list that is filled later. `done` is reached when it has finished.
  void recordInto(VkCommandBuffer commands, const SemaphoreValue& done);
  /// Drops the list after an exception since begin(). The accesses that resources remember no
  /// longer hold: buffers may be used again, images only after GpuImage::forget().
  void abandon();
  /// Blocks until the last submission has finished. Throws Error when the device is lost.
  void wait();

  /// A named pass: debug label and a pair of timestamps. Passes do not nest. Throws Error when
  /// there are more than maxPasses.
  void beginPass(const char* name);
  void endPass();
  /// Times of the last submission that was waited for, in order; passes of the same name are
  /// summed. Without timestamps on the device, all are 0.
  const std::vector<PassTiming>& timings();
  /// Time from the beginning of the first pass to the end of the last, ms.
  double frameMilliseconds();

  /// Counts since begin().
  const CommandCounts& counts() const { return counts_; }

  /// Binds a pipeline with all that its shader reads and writes. The pipeline is kept until the
  /// submission has finished. A resource may be at several bindings if the accesses agree. Inside a
  /// rendering scope, only resources that need no barrier may be bound: they were bound or used in
  /// the same way before.
  template <typename S>
  void bind(const Compute<S>& pipeline, const typename S::Bindings& bindings,
            const typename S::Push& push = {}) {
    bindPipeline(pipeline);
    bindResources(bindings.list());
    pushConstants(push);
  }
  template <typename V, typename F>
  void bind(const Graphics<V, F>& pipeline, const typename V::Bindings& ofVertices,
            const typename F::Bindings& ofFragments,
            const typename Graphics<V, F>::Push& push = {}) {
    bindPipeline(pipeline);
    bindResources(ofVertices.list());
    bindResources(ofFragments.list());
    pushConstants(push);
  }
  /// Sets other push constants for the bound pipeline.
  template <typename S>
  void push([[maybe_unused]] const Compute<S>& pipeline, const typename S::Push& push) {
    assert(pipeline_ == &pipeline);
    pushConstants(push);
  }
  /// Dispatches without a bind() between them are not ordered.
  void dispatch(std::uint32_t groupsX, std::uint32_t groupsY = 1, std::uint32_t groupsZ = 1);

  /// At least `count` invocations of a shader with 64 in a group; see shaders/lib/linear.glsl.
  /// `rounds`: roughly the most rounds of an invocation's innermost loop. Here and below, work that
  /// might take so long that a display's driver resets the device is split into several dispatches.
  void dispatchLinear(std::uint32_t count, std::uint32_t rounds = 1);

  /// The device's number of lanes for each of `count` things, for a shader with lib/lanes.glsl.
  void dispatchLanes(std::uint32_t count, std::uint32_t rounds = 1);

  /// That many work groups of a shader with lib/work_group.glsl.
  void dispatchGroups(std::uint32_t groups, std::uint32_t rounds = 1);

  /// At least one invocation for each pixel of an image, for a shader whose groups of 64 are tiles
  /// of 8×8.
  void dispatchTiles(const GpuImage& image, std::uint32_t rounds = 1);

  /// Dispatches the numbers of groups, x y z, in `groups` at `offset`; ordered with use(groups,
  /// Access::Indirect).
  void dispatchIndirect(Buffer& groups, std::size_t offset);

  /// Makes the targets attachments, with their barriers; viewport and scissor cover them.
  void beginRendering(std::span<const ColorTarget> colors, const DepthTarget* depth = nullptr);
  void beginRendering(std::initializer_list<ColorTarget> colors,
                      const DepthTarget* depth = nullptr) {
    beginRendering(std::span<const ColorTarget>(colors.begin(), colors.size()), depth);
  }
  void endRendering();
  void draw(std::uint32_t vertices, std::uint32_t firstVertex = 0);
  /// 32-bit indices; ordered with use(indices, Access::Index) before beginRendering.
  void drawIndexed(Buffer& indices, std::uint32_t count, std::uint32_t firstIndex = 0);

  void copyBuffer(Buffer& from, Buffer& to, std::size_t bytes, std::size_t fromOffset = 0,
                  std::size_t toOffset = 0);
  /// Copies to different buffers at once. Copies of 0 bytes are left out.
  void copyBuffers(std::span<const BufferCopy> copies);
  void copyToImage(Buffer& from, GpuImage& to, std::uint32_t layer = 0, std::uint32_t level = 0,
                   std::size_t fromOffset = 0);
  void copyFromImage(GpuImage& from, Buffer& to, std::uint32_t layer = 0, std::uint32_t level = 0,
                     std::size_t toOffset = 0);
  void fill(std::initializer_list<std::reference_wrapper<Buffer>> buffers, std::uint32_t value);
  /// Sets an image of floats or whole numbers to 0. Needs VK_IMAGE_USAGE_TRANSFER_DST_BIT.
  void clear(GpuImage& image);

  /// Builds the structure for the triangles in `corners`, the buffer that it was made from. A refit
  /// is faster than a new build, but rays take longer the further triangles have moved apart since.
  void build(AccelerationStructure& structure, Buffer& corners, bool refit);

  /// Orders an access that no other call implies, such as Index or HostRead.
  void use(Buffer& buffer, Access access);
  void use(GpuImage& image, Access access);
  /// Orders a later write together with the barriers before the next command, so that it needs none
  /// of its own. Nothing else may use the image in between.
  void prepare(GpuImage& image, Access write);

 private:
  static constexpr std::size_t maxSlots = CommandTape::maxResources;
  static constexpr std::size_t maxParts = Device::mostBuffers;

  /// A command buffer and its commands.
  struct Recording {
    VkCommandBuffer buffer = VK_NULL_HANDLE;
    CommandTape recorded;
    std::uint64_t retired = 0;  // Device::retired() when it was recorded
    bool keeps = false;         // the buffer may be submitted again
  };
  struct Part {
    CommandTape wanted;
    bool borrows = false;  // uses a borrowed object, whose handle may come to mean another
    Recording submitted;
    Recording executed;  // secondary, for the caller's command buffers; made when first needed
  };
  CommandTape& commands() { return parts_[part_].wanted; }
  void beginPart();
  void finishFilling();
  bool isRecorded(const Recording& recording, const Part& part) const;
  void record(const Part& part, Recording& recording, VkCommandBufferUsageFlags usage);
  void executeIn(VkCommandBuffer commands, Part& part);
  VkResult allocate(VkCommandBufferLevel level, std::span<VkCommandBuffer> buffers);

  void order(Buffer& buffer, AccessScope scope);
  void order(GpuImage& image, const AccessScope& scope);
  void add(GpuImage& image, const std::optional<AccessBarrier>& barrier);
  void flushBarriers();
  void addBarrier();
  void dispatchRows(std::uint32_t groupsX, std::uint32_t groupsY, std::uint32_t rounds);
  void bindPipeline(const Pipeline& pipeline);
  void bindResources(std::span<const Binding> bindings);
  void orderBindings(std::span<const Binding> bindings);
  void pushBytes(const void* data, std::uint32_t bytes);
  template <typename T>
  void pushConstants(const T& constants) {
    if constexpr (!std::is_empty_v<T>) pushBytes(&constants, static_cast<std::uint32_t>(sizeof(T)));
  }
  bool boundIsCurrent() const;
  void orderTarget(GpuImage& image, std::uint32_t layer, const AccessScope& scope);
  static AccessScope scopeOfTarget(const GpuImage& image, Access access);
  tape::Target attachment(const ColorTarget& target);
  tape::Target attachment(const DepthTarget& target);

  Device& device_;
  std::string name_;
  PassTimer timer_;
  VkCommandPool pool_ = VK_NULL_HANDLE;
  std::array<Part, maxParts> parts_;
  std::size_t part_ = 0;  // the part that is being filled
  bool filling_ = false;
  std::uint64_t submission_ = 0;  // not waited for yet; 0: none
  bool inPass_ = false;
  bool rendering_ = false;

  const Pipeline* pipeline_ = nullptr;
  std::uint64_t boundFor_ = 0;  // the command that followed the last bind
  // What is bound at each slot, separately for graphics and compute.
  std::array<std::array<Binding, maxSlots>, 2> bound_;

  std::array<tape::ImageBarrier, maxSlots> imageBarriers_;
  std::uint32_t imageBarrierCount_ = 0;
  AccessBarrier memoryBarrier_;
  CommandCounts counts_;
};

}  // namespace opaline::gpu
