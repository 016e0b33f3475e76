#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <string>

namespace opaline::test {

/// The layer of layer/faults.h in this process.
class FaultLayer {
 public:
  /// Every instance created from now on uses the layer.
  FaultLayer();

  /// From now on, the n-th call that may return `result` does so.
  void arm(VkResult result, std::uint64_t nth) { arm_(result, nth, nullptr); }
  void disarm() { arm_(VK_SUCCESS, 0, nullptr); }
  /// Hides a device function of the driver; null: shows all again.
  void hide(const char* function) { hide_(function); }
  /// Hides an extension of devices; null: shows all again.
  void hideExtension(const char* extension) { hideExtension_(extension); }
  /// Makes software devices claim to be hardware.
  void claimHardware(bool claims) { claimHardware_(claims); }
  /// Makes devices claim that a buffer has at most so many texels; 0: their real number.
  void claimTexels(std::uint32_t most) { claimTexels_(most); }
  /// The function that has failed since then; empty if none has.
  std::string faulted() const;
  /// Objects created and not destroyed, except for the instance that is kept until the process
  /// ends.
  std::int64_t living() const { return living_() - kept_; }
  std::string describeLiving() const { return describe_(); }

 private:
  void (*arm_)(std::int32_t, std::uint64_t, const char*) = nullptr;
  void (*hide_)(const char*) = nullptr;
  void (*hideExtension_)(const char*) = nullptr;
  void (*claimHardware_)(bool) = nullptr;
  void (*claimTexels_)(std::uint32_t) = nullptr;
  const char* (*faulted_)() = nullptr;
  std::int64_t (*living_)() = nullptr;
  const char* (*describe_)() = nullptr;
  std::int64_t kept_ = 0;
};

FaultLayer& faultLayer();

}  // namespace opaline::test
