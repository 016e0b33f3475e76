#include "python/keyword_names.h"

#include <cctype>
#include <initializer_list>

namespace opaline::python {

std::string withKeywordNames(std::string_view sentence) {
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
    sentence.remove_prefix(structure.size());
    while (!sentence.empty() && std::isalnum(static_cast<unsigned char>(sentence.front())) != 0) {
      const auto letter = static_cast<unsigned char>(sentence.front());
      if (std::isupper(letter) != 0) result += '_';
      result += static_cast<char>(std::tolower(letter));
      sentence.remove_prefix(1);
    }
  }
  return result;
}

}  // namespace opaline::python
