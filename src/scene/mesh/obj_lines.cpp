#include "scene/mesh/obj_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "opaline/error.h"
#include "scene/not_shown.h"
#include "scene/text.h"

namespace opaline::scene {

namespace {

bool hasComment(std::string_view line) {
  for (std::string_view word = nextWord(line); !word.empty(); word = nextWord(line)) {
    if (word.starts_with('#')) return true;
  }
  return false;
}

std::size_t countLines(std::string_view text) {
  std::size_t count = 0;
  for (; !text.empty(); ++count) nextLine(text);
  return count;
}

bool isNumber(std::string_view word) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  double value = 0;
  const auto [stop, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (stop != word.data() + word.size() || word.empty()) return false;
  if (problem == std::errc::result_out_of_range) return word.find("e-") != std::string_view::npos;
  return problem == std::errc{} && std::abs(value) <= double{std::numeric_limits<float>::max()};
}

void checkNumbers(const Input& input, std::string_view what, std::string_view line,
                  std::size_t number) {
  for (int i = 0; i < 3; ++i) {
    const std::string_view word = nextWord(line);
    if (word.empty() || word.starts_with('#')) {
      failObj(input,
              fmt::format("line {}: {} needs three coordinates, but has {}", number, what, i));
    }
    if (!isNumber(word)) {
      failObj(input,
              fmt::format("line {}: '{}' is not a finite number", number, cleanText(word, 40)));
    }
  }
}

std::size_t countNumbers(std::string_view line) {
  std::size_t count = 0;
  while (isNumber(nextWord(line))) ++count;
  return count;
}

/// A corner is v, v/vt, v//vn or v/vt/vn, each a whole number other than 0.
bool isCorner(std::string_view word) {
  for (int part = 0; part < 3; ++part) {
    const std::size_t end = std::min(word.find('/'), word.size());
    const std::string_view digits = word.substr(0, end);
    int value = 0;
    const auto [stop, problem] =
        std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool absent = digits.empty() && part == 1 && end < word.size();
    if (!absent &&
        (problem != std::errc{} || stop != digits.data() + digits.size() || value == 0)) {
      return false;
    }
    if (end == word.size()) return true;
    word.remove_prefix(end + 1);
  }
  return false;
}

void checkCorners(const Input& input, std::string_view line, std::size_t number) {
  for (std::string_view word = nextWord(line); !word.empty(); word = nextWord(line)) {
    if (word.starts_with('#')) return;
    if (!isCorner(word)) {
      failObj(input,
              fmt::format("line {}: '{}' is not a corner of a face", number, cleanText(word, 40)));
    }
  }
}

/// What no picture shows of such a line; empty if all of it is shown, or it only sets how others
/// are.
std::string_view kindNotShown(std::string_view keyword) {
  if (keyword == "l" || keyword == "p") return "points and lines";
  if (keyword == "curv" || keyword == "surf") return "free-form curves and surfaces";
  return {};
}

/// "off" counts as 0; none if the word is neither that nor a number.
std::optional<std::uint32_t> smoothingGroup(std::string_view word) {
  if (word == "off") return 0;
  if (word == "on") return 1;
  std::uint32_t group = 0;
  const auto [stop, problem] = std::from_chars(word.data(), word.data() + word.size(), group);
  if (word.empty() || problem != std::errc{} || stop != word.data() + word.size())
    return std::nullopt;
  return group;
}

}  // namespace

void failObj(const Input& input, const std::string& reason) {
  throw Error(fmt::format("{}: {}", cleanText(input.file.string(), 1000), reason));
}

std::string_view textOf(const Input& input) {
  return withoutByteOrderMark(
      {reinterpret_cast<const char*>(input.bytes.data()), input.bytes.size()});
}

ObjLine nextLine(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
  const bool pair = text.substr(end, 2) == "\r\n";
  const ObjLine line{text.substr(0, end), std::min(end + (pair ? 2 : 1), text.size())};
  text.remove_prefix(line.size);
  return line;
}

std::string_view nextWord(std::string_view& line) {
  const std::size_t begin = std::min(line.find_first_not_of(" \t\r"), line.size());
  line.remove_prefix(begin);
  const std::size_t end = std::min(line.find_first_of(" \t\r"), line.size());
  const std::string_view word = line.substr(0, end);
  line.remove_prefix(end);
  return word;
}

std::optional<std::string> joinedLines(std::string_view text) {
  std::optional<std::string> joined;
  std::size_t begin = 0;
  for (std::string_view rest = text; !rest.empty();) {
    const ObjLine line = nextLine(rest);
    if (line.text.ends_with('\\') && !hasComment(line.text)) {
      if (!joined) joined.emplace(text);
      const std::size_t end = line.text.size() - 1;
      joined->replace(begin + end, line.size - end, line.size - end, ' ');
    }
    begin += line.size;
  }
  return joined;
}

ObjExtras requireSoundLines(const Input& input, std::string_view text) {
  if (text.find('\0') != std::string_view::npos) {
    failObj(input, "it contains zero bytes, so it is not an OBJ file");
  }
  ObjExtras extras;
  std::size_t faces = 0;
  std::string_view file = textOf(input);
  for (std::size_t number = 1; !text.empty();) {
    const ObjLine whole = nextLine(text);
    std::string_view line = whole.text;
    const std::string_view keyword = nextWord(line);
    if (keyword == "v") checkNumbers(input, "a vertex", line, number);
    if (keyword == "vn") checkNumbers(input, "a normal", line, number);
    if (keyword == "f") checkCorners(input, line, number);
    if (const std::string_view what = kindNotShown(keyword); !what.empty())
      addNotShown(extras.notShown, what, {});
    if (keyword == "v" && countNumbers(line) >= 6) ++extras.coloredVertices;
    if (keyword == "f" && !nextWord(line).empty()) ++faces;
    if (keyword == "s")
      if (const auto group = smoothingGroup(nextWord(line)))
        extras.smoothing.push_back({faces, *group});
    if (keyword == "mtllib") extras.materialFiles.emplace_back(trimmed(line));
    number += countLines(file.substr(0, whole.size));
    file.remove_prefix(whole.size);
  }
  return extras;
}

}  // namespace opaline::scene
