#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace opaline::scene {

/// Replaces bytes that are not UTF-8 and control characters by U+FFFD. Longer text ends in "…".
std::string cleanText(std::string_view text, std::size_t longest = 200);

/// Whether the text is well-formed UTF-8.
bool isUtf8(std::string_view text);

/// The candidate with the smallest edit distance (Levenshtein 1966). A word that begins a
/// candidate, or continues it, has distance one. None if no candidate is near.
std::optional<std::string_view> nearest(std::string_view word,
                                        std::span<const std::string_view> candidates);

/// Lists words as "'a', 'b' and 'c'".
std::string listed(std::span<const std::string_view> words);

/// The same, but at most so many words and the number of the others: "'a', 'b' and 7 more".
std::string listed(std::span<const std::string_view> words, std::size_t most);

}  // namespace opaline::scene
