#include "scene/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace opaline::scene {

namespace {

/// Length of the well-formed UTF-8 character at the start of `text`, 0 if there is none
/// (Unicode 15, table 3-7).
std::size_t characterLength(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const auto follows = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  const unsigned lead = byte(0);
  if (lead < 0x80U) return 1;
  if (lead >= 0xC2U && lead <= 0xDFU) return follows(1) ? 2 : 0;
  if (lead >= 0xE0U && lead <= 0xEFU) {
    if (!follows(1) || !follows(2)) return 0;
    if (lead == 0xE0U && byte(1) < 0xA0U) return 0;
    return lead == 0xEDU && byte(1) > 0x9FU ? 0 : 3;
  }
  if (lead >= 0xF0U && lead <= 0xF4U) {
    if (!follows(1) || !follows(2) || !follows(3)) return 0;
    if (lead == 0xF0U && byte(1) < 0x90U) return 0;
    return lead == 0xF4U && byte(1) > 0x8FU ? 0 : 4;
  }
  return 0;
}

std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0U : 1U);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row[b.size()];
}

/// The candidate with the smallest edit distance (Levenshtein 1966), one letter for a beginning or
/// a continuation; none if all are further than about a third of the word.
std::optional<std::string_view> nearest(std::string_view word,
                                        std::span<const std::string_view> candidates) {
  word = word.substr(0, 64);
  std::optional<std::string_view> best;
  std::size_t least = std::max<std::size_t>((word.size() + 1) / 3, 1) + 1;
  for (const std::string_view candidate : candidates) {
    const bool begins =
        !word.empty() && (candidate.starts_with(word) || word.starts_with(candidate));
    const std::size_t distance = begins ? 1 : editDistance(word, candidate);
    if (distance >= least) continue;
    best = candidate;
    least = distance;
  }
  return best;
}

}  // namespace

std::string cleanText(std::string_view text, std::size_t longest) {
  std::string clean;
  while (!text.empty()) {
    if (clean.size() >= longest) return clean + "…";
    const std::size_t size = characterLength(text);
    const auto lead = static_cast<unsigned char>(text[0]);
    if (size == 0 || lead < 0x20U || lead == 0x7FU) {
      clean += lead == '\t' || lead == '\n' || lead == '\r' ? " " : "\xEF\xBF\xBD";
      text.remove_prefix(1);
    } else {
      clean += text.substr(0, size);
      text.remove_prefix(size);
    }
  }
  return clean;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(" \t\r"), text.size());
  text.remove_prefix(begin);
  return text.substr(0, text.find_last_not_of(" \t\r") + 1);
}

std::string_view withoutByteOrderMark(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (text.starts_with(mark)) text.remove_prefix(mark.size());
  return text;
}

bool isUtf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t size = characterLength(text);
    if (size == 0) return false;
    text.remove_prefix(size);
  }
  return true;
}

std::string suggestionOrList(std::string_view word, std::span<const std::string_view> candidates,
                             std::size_t most) {
  if (candidates.empty()) return "";
  if (const auto near = nearest(word, candidates))
    return fmt::format("; the nearest is '{}'", *near);
  return fmt::format("; there {} {}", candidates.size() == 1 ? "is only" : "are",
                     listed(candidates, most));
}

std::string listed(std::span<const std::string_view> words) {
  return listed(words, words.size());
}

std::string listed(std::span<const std::string_view> words, std::size_t most) {
  const std::size_t named = std::min(words.size(), most);
  const std::size_t more = words.size() - named;
  std::string text;
  for (std::size_t i = 0; i < named; ++i) {
    if (i > 0) text += i + 1 == named && more == 0 ? " and " : ", ";
    text += fmt::format("'{}'", words[i]);
  }
  return more > 0 ? fmt::format("{} and {} more", text, more) : text;
}

}  // namespace opaline::scene
