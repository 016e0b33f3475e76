#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace opaline::gpu {

struct DeviceFunctions;
struct RayFunctions;

/// Objects that nobody will use again, but that a device may still be working with.
class RetiredObjects {
 public:
  bool empty() const { return objects_.empty(); }
  /// How many have been added so far.
  std::uint64_t count() const { return count_; }
  /// `bytes` of memory, where the object is that. The device uses it up to the submission of that
  /// number. Throws std::bad_alloc, but counts the object.
  void add(std::uint64_t submission, VkObjectType type, std::uint64_t handle, std::size_t bytes);
  /// Destroys those that a device which has finished that submission no longer uses, in the order
  /// in which they were added. Returns how much memory that frees, bytes.
  std::size_t destroyUpTo(std::uint64_t submission, VkDevice device, const DeviceFunctions& vk,
                          const RayFunctions& rays);
  /// Destroys one that the device no longer uses.
  static void destroy(VkObjectType type, std::uint64_t handle, VkDevice device,
                      const DeviceFunctions& vk, const RayFunctions& rays);

 private:
  struct Object {
    std::uint64_t submission = 0;
    VkObjectType type = VK_OBJECT_TYPE_UNKNOWN;
    std::uint64_t handle = 0;
    std::size_t bytes = 0;
  };
  std::vector<Object> objects_;
  std::uint64_t count_ = 0;
};

}  // namespace opaline::gpu
