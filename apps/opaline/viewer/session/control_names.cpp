#include "viewer/session/control_names.h"

#include <array>
#include <cstddef>
#include <utility>

#include "cli/field_names.h"

namespace opaline::app::viewer {

std::string withControlNames(std::string_view note) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> controls{
      {{"--diagonal-mm", "the size under Medium"},
       {"--max-clusters", "clusters under Method"},
       {"--site auto", "auto for site under Method"}}};
  std::string text = withOptionNames(note);
  for (const auto& [option, control] : controls)
    if (const std::size_t at = text.find(option); at != std::string::npos)
      text.replace(at, option.size(), control);
  return text;
}

}  // namespace opaline::app::viewer
