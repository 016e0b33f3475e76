#include "c_interface/status.h"

#include <algorithm>
#include <array>

#include "opaline/version.h"

namespace opaline::c {

namespace {

/// Of fixed length, because memory may have run out.
thread_local std::array<char, 4096> lastMessage{};

}  // namespace

OpalineStatus failed(OpalineStatus status, std::string_view message) noexcept {
  const std::size_t length = std::min(message.size(), lastMessage.size() - 1);
  std::copy_n(message.begin(), length, lastMessage.begin());
  lastMessage[length] = '\0';
  return status;
}

}  // namespace opaline::c

extern "C" {

const char* opalineLastError(void) {
  return opaline::c::lastMessage.data();
}

void opalineVersion(int32_t* major, int32_t* minor, int32_t* patch, int32_t* abi) {
  if (major) *major = OPALINE_VERSION_MAJOR;
  if (minor) *minor = OPALINE_VERSION_MINOR;
  if (patch) *patch = OPALINE_VERSION_PATCH;
  if (abi) *abi = OPALINE_C_ABI;
}

}  // extern "C"
