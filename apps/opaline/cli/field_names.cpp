#include "cli/field_names.h"

#include <cctype>
#include <initializer_list>

namespace opaline::app {

std::string withOptionNames(std::string_view sentence) {
  std::string result;
  while (!sentence.empty()) {
    std::string_view structure;
    for (const std::string_view name : {"RenderOptions::", "RendererOptions::", "LoadOptions::"})
      if (sentence.starts_with(name)) structure = name;
    if (structure.empty()) {
      result += sentence.front();
      sentence.remove_prefix(1);
      continue;
    }
    // An option is named after its field: RenderOptions::maxSurfels, --max-surfels.
    sentence.remove_prefix(structure.size());
    result += "--";
    while (!sentence.empty() && std::isalnum(static_cast<unsigned char>(sentence.front())) != 0) {
      const auto letter = static_cast<unsigned char>(sentence.front());
      if (std::isupper(letter) != 0) result += '-';
      result += static_cast<char>(std::tolower(letter));
      sentence.remove_prefix(1);
    }
  }
  return result;
}

}  // namespace opaline::app
