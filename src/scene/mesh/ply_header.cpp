#include "scene/mesh/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <utility>

#include "opaline/error.h"
#include "scene/text.h"

// The format: G. Turk, "The PLY Polygon File Format", 1994.

namespace opaline::scene {

namespace {

std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> result;
  while (true) {
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return result;
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(" \t\r"), line.size());
    result.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

std::optional<PlyScalar> scalarNamed(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, PlyScalar>, 16> names{{
      {"char", PlyScalar::Int8},
      {"int8", PlyScalar::Int8},
      {"uchar", PlyScalar::Uint8},
      {"uint8", PlyScalar::Uint8},
      {"short", PlyScalar::Int16},
      {"int16", PlyScalar::Int16},
      {"ushort", PlyScalar::Uint16},
      {"uint16", PlyScalar::Uint16},
      {"int", PlyScalar::Int32},
      {"int32", PlyScalar::Int32},
      {"uint", PlyScalar::Uint32},
      {"uint32", PlyScalar::Uint32},
      {"float", PlyScalar::Float32},
      {"float32", PlyScalar::Float32},
      {"double", PlyScalar::Float64},
      {"float64", PlyScalar::Float64},
  }};
  for (const auto& [known, type] : names) {
    if (known == name) return type;
  }
  return std::nullopt;
}

PlyProperty parseProperty(const Input& input, const std::vector<std::string_view>& line) {
  PlyProperty property;
  if (line.size() == 5 && line[1] == "list") {
    const auto count = scalarNamed(line[2]);
    const auto type = scalarNamed(line[3]);
    if (count && type && *count < PlyScalar::Float32) {
      return {std::string(line[4]), *type, *count};
    }
  } else if (line.size() == 3) {
    if (const auto type = scalarNamed(line[1])) return {std::string(line[2]), *type, std::nullopt};
  }
  failPly(input, "the PLY header declares a property of a kind that does not exist");
}

PlyElement parseElement(const Input& input, const std::vector<std::string_view>& line) {
  PlyElement element;
  if (line.size() != 3) failPly(input, "the PLY header has an incomplete element line");
  element.name = line[1];
  const char* end = line[2].data() + line[2].size();
  const auto [stop, problem] = std::from_chars(line[2].data(), end, element.count);
  if (problem != std::errc{} || stop != end) {
    failPly(input, fmt::format("the PLY header gives '{}' as the number of '{}'",
                               cleanText(line[2], 40), cleanText(element.name, 40)));
  }
  return element;
}

}  // namespace

std::size_t sizeOf(PlyScalar type) {
  constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

void failPly(const Input& input, const std::string& reason) {
  throw Error(fmt::format("{}: {}", cleanText(input.file.string(), 1000), reason));
}

PlyHeader parsePlyHeader(const Input& input) {
  constexpr std::size_t longestHeader = 1U << 20U;
  const std::string_view text(reinterpret_cast<const char*>(input.bytes.data()),
                              std::min(input.bytes.size(), longestHeader));
  PlyHeader header;
  std::size_t at = 0;
  bool sawFormat = false;
  bool pairs = false;
  for (std::size_t lineNumber = 0;; ++lineNumber) {
    // Line ends are \n, \r\n or, in files from old Macintoshes, \r.
    const std::size_t end = text.find_first_of("\r\n", at);
    if (end == std::string_view::npos) {
      failPly(input, lineNumber == 0 ? "this is not a PLY file" : "the PLY header has no end");
    }
    const std::vector<std::string_view> line = words(text.substr(at, end - at));
    at = end + 1;
    // Decided once, at the first line: after a lone \r the body may begin with a byte like \n.
    if (lineNumber == 0) pairs = text.substr(end).starts_with("\r\n");
    if (pairs && text.substr(end).starts_with("\r\n")) ++at;
    if (lineNumber == 0) {
      if (line.size() != 1 || line[0] != "ply") failPly(input, "this is not a PLY file");
      continue;
    }
    if (line.empty() || line[0] == "comment" || line[0] == "obj_info") continue;
    if (line[0] == "end_header") break;
    if (line[0] == "format" && line.size() == 3) {
      sawFormat = true;
      if (line[1] == "ascii") {
        header.encoding = PlyEncoding::Ascii;
      } else if (line[1] == "binary_little_endian") {
        header.encoding = PlyEncoding::Little;
      } else if (line[1] == "binary_big_endian") {
        header.encoding = PlyEncoding::Big;
      } else {
        failPly(input, fmt::format("the PLY format '{}' does not exist", cleanText(line[1], 40)));
      }
    } else if (line[0] == "element") {
      header.elements.push_back(parseElement(input, line));
    } else if (line[0] == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(parseProperty(input, line));
    } else {
      failPly(input,
              fmt::format("line {} of the PLY header is '{}', but a format, an element, or a "
                          "property of an element must stand there",
                          lineNumber + 1, cleanText(std::string(line[0]), 40)));
    }
  }
  if (!sawFormat) failPly(input, "the PLY header names no format");
  header.bytes = at;
  return header;
}

}  // namespace opaline::scene
