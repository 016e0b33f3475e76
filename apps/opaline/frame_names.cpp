#include "frame_names.h"

#include <utility>

namespace opaline::app {

std::optional<FrameNames> FrameNames::parse(const std::string& text) {
  auto name = core::NumberedName::parse(text);
  return name ? std::optional(FrameNames(std::move(*name))) : std::nullopt;
}

std::string FrameNames::common() const {
  const std::string& before = name_.before();
  const std::string name = before.substr(0, before.find_last_not_of("_-. ") + 1) + name_.after();
  return name.empty() ? "frame" : name;
}

}  // namespace opaline::app
