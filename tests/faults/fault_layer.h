#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <string>

namespace opaline::test {

/// The layer of layer/faults.h in this process.
class FaultLayer {
 public:
  /// Has every instance from now on use it.
  FaultLayer();

  /// Of the calls that may return `result`, the n-th from now on does.
  void arm(VkResult result, std::uint64_t nth) { arm_(result, nth, nullptr); }
  void disarm() { arm_(VK_SUCCESS, 0, nullptr); }
  /// The driver has no such function of devices; null: it has all of them again.
  void hide(const char* function) { hide_(function); }
  /// Devices do not list that extension; null: they list all they have again.
  void hideExtension(const char* extension) { hideExtension_(extension); }
  /// Software devices say that they are hardware.
  void claimHardware(bool claims) { claimHardware_(claims); }
  /// Devices say that a buffer has no more texels; 0: as many as it has.
  void claimTexels(std::uint32_t most) { claimTexels_(most); }
  /// The function that failed since then; empty if none has.
  std::string faulted() const;
  /// Objects that were created and not destroyed, beside the instance that is kept until the
  /// process ends.
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
