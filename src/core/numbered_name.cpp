#include "opaline/numbered_name.h"

#include <fmt/format.h>

#include <charconv>

namespace opaline {

namespace {

struct Mark {
  std::size_t length = 0;
  std::size_t digits = 0;
};

std::optional<Mark> markAt(std::string_view text, std::size_t at) {
  const std::string_view rest = text.substr(at, 4);
  if (rest.starts_with("%d")) return Mark{2, 0};
  const bool padded = rest.size() == 4 && rest.starts_with("%0") && rest[2] >= '1' &&
                      rest[2] <= '9' && rest[3] == 'd';
  if (padded) return Mark{4, static_cast<std::size_t>(rest[2] - '0')};
  return std::nullopt;
}

}  // namespace

std::optional<NumberedName> NumberedName::parse(std::string_view text) {
  std::optional<NumberedName> name;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const std::optional<Mark> mark = markAt(text, at);
    if (!mark) continue;
    if (name) return std::nullopt;
    name.emplace();
    name->before_ = text.substr(0, at);
    name->after_ = text.substr(at + mark->length);
    name->digits_ = mark->digits;
  }
  return name;
}

std::string NumberedName::with(int number) const {
  return fmt::format("{}{:0{}}{}", before_, number, digits_, after_);
}

std::optional<int> NumberedName::numberOf(std::string_view name) const {
  if (name.size() <= before_.size() + after_.size() || !name.starts_with(before_) ||
      !name.ends_with(after_)) {
    return std::nullopt;
  }
  const char* const begin = name.data() + before_.size();
  const char* const end = name.data() + name.size() - after_.size();
  int number = -1;
  const auto [stop, problem] = std::from_chars(begin, end, number);
  if (problem != std::errc() || stop != end || number < 0) return std::nullopt;
  return with(number) == name ? std::optional(number) : std::nullopt;
}

}  // namespace opaline
