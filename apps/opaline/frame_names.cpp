#include "frame_names.h"

#include <fmt/format.h>

namespace opaline::app {

namespace {

struct Mark {
  std::size_t length;
  int digits;
};

std::optional<Mark> markAt(const std::string& text, std::size_t at) {
  if (text.compare(at, 2, "%d") == 0) return Mark{2, 0};
  const bool padded = text.size() >= at + 4 && text[at] == '%' && text[at + 1] == '0' &&
                      text[at + 2] >= '1' && text[at + 2] <= '9' && text[at + 3] == 'd';
  if (padded) return Mark{4, text[at + 2] - '0'};
  return std::nullopt;
}

}  // namespace

std::optional<FrameNames> FrameNames::parse(const std::string& text) {
  std::optional<FrameNames> names;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const std::optional<Mark> mark = markAt(text, at);
    if (!mark) continue;
    if (names) return std::nullopt;
    names.emplace();
    names->before_ = text.substr(0, at);
    names->after_ = text.substr(at + mark->length);
    names->digits_ = mark->digits;
  }
  return names;
}

std::filesystem::path FrameNames::file(int number) const {
  return fmt::format("{}{:0{}}{}", before_, number, digits_, after_);
}

std::string FrameNames::common() const {
  const std::string name = before_.substr(0, before_.find_last_not_of("_-. ") + 1) + after_;
  return name.empty() ? "frame" : name;
}

}  // namespace opaline::app
