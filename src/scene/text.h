#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace opaline::scene {

/// Replaces bytes that are not UTF-8 and control characters by U+FFFD. Longer text ends in "…".
std::string cleanText(std::string_view text, std::size_t longest = 200);

/// The text without blanks around it.
std::string_view trimmed(std::string_view text);

/// The text without the byte-order mark that some editors put before UTF-8.
std::string_view withoutByteOrderMark(std::string_view text);

/// Whether the text is well-formed UTF-8.
bool isUtf8(std::string_view text);

/// "; the nearest is 'a'" where one differs by at most about a third of the word; otherwise those
/// there are, at most so many: "; there are 'a', 'b' and 7 more".
std::string suggestionOrList(std::string_view word, std::span<const std::string_view> candidates,
                             std::size_t most = 4);

/// Lists words as "'a', 'b' and 'c'".
std::string listed(std::span<const std::string_view> words);

/// The same, but at most so many words and the number of the others: "'a', 'b' and 7 more".
std::string listed(std::span<const std::string_view> words, std::size_t most);

}  // namespace opaline::scene
