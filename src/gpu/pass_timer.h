#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace opaline::gpu {

class CommandTape;
class Device;

/// GPU time between the begin and the end of one named pass.
struct PassTiming {
  std::string name;
  double milliseconds = 0;
};

/// Pairs of timestamps around the passes of one submission. If the device's queue has no
/// timestamps, passes take 0 ms.
class PassTimer {
 public:
  PassTimer(Device& device, const std::string& name, std::uint32_t maxPasses);
  ~PassTimer();
  PassTimer(const PassTimer&) = delete;
  PassTimer& operator=(const PassTimer&) = delete;

  /// Has to be the first call of a submission.
  void reset();
  /// Throws Error when there are more than maxPasses.
  void begin(CommandTape& commands, const char* name);
  void end(CommandTape& commands);

  /// Reads the timestamps of a submission that has finished.
  void collect();
  /// The times that were collected last.
  const std::vector<PassTiming>& timings() const { return timings_; }
  double frameMilliseconds() const { return frameMilliseconds_; }

 private:
  double millisecondsBetween(std::uint64_t from, std::uint64_t to) const;
  void add(const std::string& name, double milliseconds);

  Device& device_;
  VkQueryPool pool_ = VK_NULL_HANDLE;  // null: no timestamps
  std::uint64_t mask_ = 0;
  double millisecondsPerTick_ = 0;
  std::uint32_t count_ = 0;
  std::vector<std::string> names_;
  std::vector<std::uint64_t> ticks_;
  std::vector<PassTiming> timings_;
  std::size_t named_ = 0;  // how many of `timings_` have been filled in
  double frameMilliseconds_ = 0;
};

}  // namespace opaline::gpu
