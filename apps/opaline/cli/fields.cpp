#include "cli/fields.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace opaline::app {

std::string optionOf(std::string_view key) {
  std::string option = "--" + std::string(key);
  std::replace(option.begin(), option.end(), '_', '-');
  return option;
}

std::string placeholderOf(const options::Value& like) {
  if (std::holds_alternative<int>(like)) return "N";
  if (std::holds_alternative<std::string>(like)) return "NAME";
  if (std::holds_alternative<options::Size>(like)) return "WxH";
  if (std::holds_alternative<float>(like) || std::holds_alternative<double>(like)) return "X";
  return "R,G,B";
}

std::string helpOf(std::string_view help, const options::Allowed& allowed,
                   const options::Value& like, const std::string& standard) {
  std::string text{help};
  if (std::holds_alternative<std::string>(like)) {
    if (!allowed.choices.empty()) text += fmt::format(": {}", fmt::join(allowed.choices, ", "));
  } else if (!allowed.counts.empty()) {
    text += fmt::format(", {}", fmt::join(allowed.counts, " "));
  } else {
    text += fmt::format(", {} to {} {}", options::numberText(allowed.range.least),
                        options::numberText(allowed.range.most), allowed.range.unit);
    if (text.back() == ' ') text.pop_back();
    if (!allowed.choices.empty()) text += fmt::format(", or {}", fmt::join(allowed.choices, ", "));
  }
  return standard.empty() ? text : text + fmt::format(" [{}]", standard);
}

}  // namespace opaline::app
