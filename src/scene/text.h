#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace opaline::scene {

/// Bytes that are no UTF-8 and control characters become U+FFFD; longer text ends in "…".
std::string cleanText(std::string_view text, std::size_t longest = 200);

/// Whether it is well-formed UTF-8.
bool isUtf8(std::string_view text);

/// The candidate with the smallest edit distance (Levenshtein 1966), one letter for a beginning or
/// a continuation; none if there is none.
std::optional<std::string_view> nearest(std::string_view word,
                                        std::span<const std::string_view> candidates);

/// "'a', 'b' and 'c'".
std::string listed(std::span<const std::string_view> words);

/// The same of so many, and how many more there are: "'a', 'b' and 7 more".
std::string listed(std::span<const std::string_view> words, std::size_t most);

}  // namespace opaline::scene
