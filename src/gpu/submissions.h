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

/// Submissions to a queue, by this device or by the caller, numbered in order from 1 on, and the
/// semaphores that tell when they have finished.
class Submissions {
 public:
  Submissions();

  enum class By { Device, Others };
  /// Adds the submission that has finished once `done` is reached. Returns its number.
  std::uint64_t add(const SemaphoreValue& done, By by);
  /// The number of the last submission.
  std::uint64_t last() const { return last_; }

  /// The number up to which all have finished. For a lost device it no longer changes.
  std::uint64_t finished(const DeviceFunctions& vk, VkDevice device);
  /// Has to be called before submitting, so that add() cannot fail afterwards.
  void makeRoom() { unfinished_.reserve(unfinished_.size() + 1); }

  /// Blocks until all up to that number have finished. Throws Error when the device is lost, and
  /// when the caller has not submitted recorded work within a minute.
  void waitFor(std::uint64_t number, const DeviceFunctions& vk, VkDevice device);
  /// The same without exceptions: VK_TIMEOUT for work that the caller has not submitted.
  VkResult tryWaitFor(std::uint64_t number, const DeviceFunctions& vk, VkDevice device);

 private:
  struct Point {
    std::uint64_t number = 0;
    SemaphoreValue done;
    By by = By::Device;
  };
  std::vector<Point> unfinished_;  // not known to have finished
  std::uint64_t last_ = 0;
};

}  // namespace opaline::gpu
