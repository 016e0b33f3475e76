#include "state.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace opaline::faults {

namespace {

unsigned kindOf(VkResult result) {
  switch (result) {
    case VK_ERROR_OUT_OF_HOST_MEMORY:
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
      return ofMemory;
    case VK_ERROR_DEVICE_LOST:
      return ofDevice;
    case VK_ERROR_INITIALIZATION_FAILED:
      return ofInitialization;
    case VK_ERROR_MEMORY_MAP_FAILED:
      return ofMapping;
    case VK_TIMEOUT:
      return ofTime;
    case VK_ERROR_SURFACE_LOST_KHR:
      return ofSurface;
    case VK_ERROR_OUT_OF_DATE_KHR:
      return ofAge;
    default:
      return 0;
  }
}

}  // namespace

State::State() {
  const char* order = std::getenv("OPALINE_FAULT");
  if (order == nullptr) return;
  int result = 0;
  unsigned long long nth = 0;
  std::array<char, 64> function{};
  if (std::sscanf(order, "%d:%llu:%63s", &result, &nth, function.data()) < 2) std::abort();
  arm(static_cast<VkResult>(result), nth, function.front() == 0 ? nullptr : function.data());
}

State::~State() {
  const char* file = std::getenv("OPALINE_FAULT_REPORT");
  std::FILE* report = file == nullptr ? nullptr : std::fopen(file, "a");
  if (report == nullptr) return;
  std::fprintf(report, "%s %llu calls, left: %s\n", faulted_ == nullptr ? "none" : faulted_,
               static_cast<unsigned long long>(calls_), describe().c_str());
  std::fclose(report);
}

void State::arm(VkResult result, std::uint64_t nth, const char* function) {
  const std::lock_guard lock(mutex_);
  result_ = result;
  kind_ = kindOf(result);
  nth_ = nth;
  function_ = function == nullptr ? "" : function;
  calls_ = 0;
  faulted_ = nullptr;
}

std::atomic<std::int64_t>& State::living(const char* kind) {
  const std::lock_guard lock(mutex_);
  for (Kind& known : kinds_) {
    if (known.name == nullptr) known.name = kind;
    if (std::strcmp(known.name, kind) == 0) return known.living;
  }
  std::abort();
}

std::int64_t State::living() const {
  std::int64_t sum = 0;
  for (const Kind& kind : kinds_) sum += kind.living;
  return sum;
}

std::string State::describe() const {
  std::string text;
  for (const Kind& kind : kinds_) {
    if (kind.living == 0) continue;
    if (!text.empty()) text += ", ";
    text += std::to_string(kind.living) + " " + kind.name;
  }
  return text.empty() ? "nothing" : text;
}

State& state() {
  static State all;
  return all;
}

}  // namespace opaline::faults
