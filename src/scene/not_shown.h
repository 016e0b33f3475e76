#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace opaline::scene {

/// A kind of thing that a file holds and that no picture shows.
struct NotShown {
  std::string what;  ///< in the plural
  std::size_t count = 0;
  std::vector<std::string> names;  ///< of some of them, clean
};

/// Counts one more thing of a kind. Its name may be empty, and may have been counted before.
void addNotShown(std::vector<NotShown>& to, std::string_view what, std::string_view name);

/// "base-colour textures (2: skin, hair), vertex colours (1: body)".
std::string textOf(const std::vector<NotShown>& kinds);

}  // namespace opaline::scene
