#include "c_interface/values.h"

namespace opaline::c {

LogCallback logOf(OpalineLog log, void* context) {
  if (!log) return {};
  return [log, context](LogLevel level, std::string_view message) {
    log(context, static_cast<OpalineLogLevel>(level), std::string(message).c_str());
  };
}

void requireCount(std::size_t count, std::size_t most, const char* name) {
  if (count > most)
    throw UsageError(fmt::format("{}: {} are given; there may be {}.", name, count, most));
}

std::vector<std::string> stringsOf(const char* const* strings, std::size_t count,
                                   const char* name) {
  constexpr std::size_t most = 1024;  // Vulkan has a few hundred extensions
  requireCount(count, most, name);
  if (count > 0) required(strings, name);
  std::vector<std::string> made;
  for (std::size_t i = 0; i < count; ++i) made.emplace_back(&required(strings[i], name));
  return made;
}

void give(std::string_view text, char* to, std::size_t roomBytes, const char* name) {
  required(to, name);
  if (roomBytes == 0) throw UsageError(fmt::format("{} needs room for at least one byte.", name));
  const std::size_t length = std::min(text.size(), roomBytes - 1);
  std::copy_n(text.begin(), length, to);
  to[length] = '\0';
}

}  // namespace opaline::c
