#include "c_interface/living.h"

#include <mutex>
#include <shared_mutex>
#include <string_view>
#include <unordered_map>

namespace opaline::c {

namespace {

struct LivingHandles {
  std::shared_mutex mutex;
  std::unordered_map<const void*, std::string_view> kinds;
};

// Never destroyed: a program may destroy handles at its end, after the library's static objects.
LivingHandles& all() {
  static auto& handles = *new LivingHandles;
  return handles;
}

}  // namespace

void addLiving(const void* handle, const char* kind) {
  const std::unique_lock lock(all().mutex);
  all().kinds.emplace(handle, kind);
}

void removeLiving(const void* handle) noexcept {
  const std::unique_lock lock(all().mutex);
  all().kinds.erase(handle);
}

bool isLiving(const void* handle, const char* kind) noexcept {
  const std::shared_lock lock(all().mutex);
  const auto found = all().kinds.find(handle);
  return found != all().kinds.end() && found->second == kind;
}

}  // namespace opaline::c
