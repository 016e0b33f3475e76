#pragma once

#include <vulkan/vulkan.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>

namespace opaline::faults {

/// Results that Vulkan 1.3 allows a function, and others that drivers are known to return.
enum Failures : unsigned {
  ofMemory = 1,
  ofDevice = 2,
  ofInitialization = 4,
  ofMapping = 8,
  ofTime = 16,
  ofSurface = 32,
  ofAge = 64,
};

struct Call {
  const char* name;
  unsigned failures;
  PFN_vkVoidFunction next = nullptr;
  const char* makes = nullptr;  ///< kind of object
  std::atomic<std::int64_t>* living = nullptr;
};

/// Which call must fail, and which objects exist.
class State {
 public:
  State();
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State();

  void arm(VkResult result, std::uint64_t nth, const char* function);

  /// Counts a call and says whether it must fail. `lose` is called before a call says that the
  /// device is lost: its work must not outlive what it uses, and nobody can wait for it any more.
  template <typename Lose>
  bool fails(const Call& call, const Lose& lose) {
    const std::lock_guard lock(mutex_);
    if ((call.failures & kind_) == 0) return false;
    if (!function_.empty() && function_ != call.name) return false;
    ++calls_;
    if (nth_ == 0 || calls_ < nth_) return false;
    const bool lost = result_ == VK_ERROR_DEVICE_LOST;
    if (calls_ == nth_) faulted_ = call.name;
    if (lost) lose();
    return lost || calls_ == nth_;
  }

  VkResult result() const { return result_; }
  std::uint64_t calls() const { return calls_; }
  const char* faulted() const { return faulted_; }

  /// The number of objects of that kind.
  std::atomic<std::int64_t>& living(const char* kind);
  std::int64_t living() const;
  /// The kinds of existing objects, with counts.
  std::string describe() const;

 private:
  struct Kind {
    const char* name = nullptr;
    std::atomic<std::int64_t> living = 0;
  };

  std::mutex mutex_;
  VkResult result_ = VK_SUCCESS;
  unsigned kind_ = 0;
  std::uint64_t nth_ = 0;
  std::string function_;
  std::uint64_t calls_ = 0;
  const char* faulted_ = nullptr;
  std::array<Kind, 32> kinds_;
};

/// The state of the process. The environment arms it before anybody else does.
State& state();

}  // namespace opaline::faults
