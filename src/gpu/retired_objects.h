#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace opaline::gpu {

struct DeviceFunctions;
struct RayFunctions;

/// Objects that are no longer needed, but that a device may still be using.
class RetiredObjects {
 public:
  bool empty() const { return objects_.empty(); }
  /// How many have been added so far.
  std::uint64_t count() const { return count_; }
  /// Adds an object that the device uses up to the submission of that number; `bytes` if it is
  /// memory. Throws std::bad_alloc, but counts the object even then.
  void add(std::uint64_t submission, VkObjectType type, std::uint64_t handle, std::size_t bytes);
  /// Destroys, in the order of adding, the objects that the device no longer uses once it has
  /// finished that submission. Returns how many bytes of memory that frees.
  std::size_t destroyUpTo(std::uint64_t submission, VkDevice device, const DeviceFunctions& vk,
                          const RayFunctions& rays);
  /// Destroys an object that the device no longer uses.
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
