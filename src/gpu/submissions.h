#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <vector>

namespace opaline::gpu {

struct DeviceFunctions;

/// A value of a timeline semaphore.
struct SemaphoreValue {
  VkSemaphore semaphore = VK_NULL_HANDLE;
  std::uint64_t value = 0;
};

/// What was handed to a queue, by this device or in others' submissions, numbered in its order from
/// 1 on, and what tells when it has finished.
class Submissions {
 public:
  Submissions();

  enum class By { Device, Others };
  /// The number of what will have finished once `done` is reached.
  std::uint64_t add(const SemaphoreValue& done, By by);
  /// Of the last.
  std::uint64_t last() const { return last_; }

  /// Up to which number all have finished. A lost device cannot say; then it stays as it was.
  std::uint64_t finished(const DeviceFunctions& vk, VkDevice device);
  /// Before something is submitted, so that nothing fails between that and add().
  void makeRoom() { unfinished_.reserve(unfinished_.size() + 1); }

  /// Blocks until all up to that number have finished. Throws Error when the device is lost, and
  /// when others have not submitted in a minute what they recorded.
  void waitFor(std::uint64_t number, const DeviceFunctions& vk, VkDevice device);
  /// The same without exceptions: VK_TIMEOUT for what others have not submitted.
  VkResult tryWaitFor(std::uint64_t number, const DeviceFunctions& vk, VkDevice device);

 private:
  struct Point {
    std::uint64_t number = 0;
    SemaphoreValue done;
    By by = By::Device;
  };
  std::vector<Point> unfinished_;  // as far as it is known
  std::uint64_t last_ = 0;
};

}  // namespace opaline::gpu
