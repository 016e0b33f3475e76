#include "cli/field_names.h"

#include <array>
#include <utility>

namespace opaline::app {

namespace {

// Every field that a message of the library names.
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> options{{
    {"RenderOptions::maxSources", "--max-sources"},
    {"RenderOptions::boundarySurfels", "--boundary-surfels"},
    {"LoadOptions::diagonalMm", "--diagonal-mm"},
    {"LoadOptions::morphTo", "--morph-to"},
}};

}  // namespace

std::string withOptionNames(std::string_view sentence) {
  std::string result(sentence);
  for (const auto& [field, option] : options) {
    for (std::size_t at = result.find(field); at != std::string::npos;
         at = result.find(field, at + option.size())) {
      result.replace(at, field.size(), option);
    }
  }
  return result;
}

}  // namespace opaline::app
