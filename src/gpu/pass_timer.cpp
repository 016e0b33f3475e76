#include "gpu/pass_timer.h"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>

#include "gpu/command_tape.h"
#include "gpu/device.h"
#include "gpu/vulkan_result.h"
#include "opaline/error.h"

namespace opaline::gpu {

namespace {

std::uint32_t timestampBits(const Device& device) {
  std::uint32_t count = 0;
  device.instanceFunctions().vkGetPhysicalDeviceQueueFamilyProperties(device.physical(), &count,
                                                                      nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  device.instanceFunctions().vkGetPhysicalDeviceQueueFamilyProperties(device.physical(), &count,
                                                                      families.data());
  return families.at(device.queueFamily()).timestampValidBits;
}

}  // namespace

PassTimer::PassTimer(Device& device, const std::string& name, std::uint32_t maxPasses)
    : device_(device),
      millisecondsPerTick_(static_cast<double>(device.limits().timestampPeriod) * 1e-6),
      names_(maxPasses),
      ticks_(std::size_t{2} * maxPasses) {
  timings_.reserve(maxPasses);
  const std::uint32_t bits = timestampBits(device);
  if (bits == 0 || maxPasses == 0) return;
  mask_ = bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
  VkQueryPoolCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
  info.queryType = VK_QUERY_TYPE_TIMESTAMP;
  info.queryCount = 2 * maxPasses;
  check(device.vk().vkCreateQueryPool(device.handle(), &info, nullptr, &pool_),
        "create timestamps");
  device.setName(VK_OBJECT_TYPE_QUERY_POOL, reinterpret_cast<std::uint64_t>(pool_), name);
}

PassTimer::~PassTimer() {
  device_.retire(VK_OBJECT_TYPE_QUERY_POOL, pool_);
}

void PassTimer::reset() {
  count_ = 0;
}

// Both timestamps wait for everything before them, so that passes that overlap on the device are
// not counted twice.
void PassTimer::begin(CommandTape& commands, const char* name) {
  if (count_ == names_.size()) {
    throw Error(fmt::format("a frame has more than {} passes at \"{}\"", names_.size(), name));
  }
  names_[count_] = name;
  if (pool_ == VK_NULL_HANDLE) return;
  // The largest pictures have thousands of passes, most have few.
  constexpr std::uint32_t passesAtOnce = 64;
  if (count_ % passesAtOnce == 0) {
    const auto left = static_cast<std::uint32_t>(names_.size()) - count_;
    commands.add(tape::ResetQueries{pool_, 2 * count_, 2 * std::min(passesAtOnce, left)});
  }
  commands.add(tape::WriteTimestamp{pool_, 2 * count_});
  // Mesa's software device reads the clock only at the next barrier.
  if (device_.info().type == DeviceType::Software)
    commands.add({.fromStages = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                  .toStages = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT},
                 {});
}

void PassTimer::end(CommandTape& commands) {
  assert(count_ < names_.size());
  if (pool_ != VK_NULL_HANDLE) commands.add(tape::WriteTimestamp{pool_, 2 * count_ + 1});
  ++count_;
}

void PassTimer::collect() {
  const std::size_t queries = std::size_t{2} * count_;
  frameMilliseconds_ = 0;
  named_ = 0;
  if (pool_ != VK_NULL_HANDLE && queries > 0) {
    check(device_.vk().vkGetQueryPoolResults(device_.handle(), pool_, 0, 2 * count_,
                                             queries * sizeof(std::uint64_t), ticks_.data(),
                                             sizeof(std::uint64_t),
                                             VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
          "read the timestamps");
  }
  for (std::size_t i = 0; i < count_; ++i) {
    add(names_[i], millisecondsBetween(ticks_[2 * i], ticks_[2 * i + 1]));
  }
  timings_.resize(named_);
  if (queries > 0) frameMilliseconds_ = millisecondsBetween(ticks_[0], ticks_[queries - 1]);
}

double PassTimer::millisecondsBetween(std::uint64_t from, std::uint64_t to) const {
  // The mask corrects a counter that wrapped around. A counter that went back a little, as software
  // devices' do between cores, counts as no time.
  const std::uint64_t ticks = (to - from) & mask_;
  return ticks > mask_ / 2 ? 0 : static_cast<double>(ticks) * millisecondsPerTick_;
}

void PassTimer::add(const std::string& name, double milliseconds) {
  const auto end = timings_.begin() + static_cast<std::ptrdiff_t>(named_);
  const auto same = std::find_if(timings_.begin(), end,
                                 [&](const PassTiming& timing) { return timing.name == name; });
  if (same != end) {
    same->milliseconds += milliseconds;
    return;
  }
  // The entries of the last frame are overwritten, so that their strings need no new memory.
  if (named_ == timings_.size()) timings_.emplace_back();
  timings_[named_].name = name;
  timings_[named_].milliseconds = milliseconds;
  ++named_;
}

}  // namespace opaline::gpu
