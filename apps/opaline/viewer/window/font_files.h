#pragma once

#include <filesystem>
#include <set>
#include <vector>

namespace opaline::app::viewer {

/// A font of the system.
struct FontFile {
  std::filesystem::path file;
  int index = 0;           ///< in a file of several
  std::set<char32_t> has;  ///< of the characters that were asked for
};

/// The system's upright sans-serif, and what else it takes to show these characters, as far as it
/// has any. Empty where the system has no fonts.
std::vector<FontFile> fontsFor(const std::set<char32_t>& characters);

}  // namespace opaline::app::viewer
