#pragma once

#include <filesystem>
#include <set>
#include <vector>

namespace opaline::app::viewer {

/// A font of the system.
struct FontFile {
  std::filesystem::path file;
  int index = 0;           ///< in a file with several fonts
  std::set<char32_t> has;  ///< which of the wanted characters it has
};

/// The system's upright sans-serif, and more fonts as needed for these characters, as far as the
/// system has them. Empty where it has no fonts.
std::vector<FontFile> fontsFor(const std::set<char32_t>& characters);

}  // namespace opaline::app::viewer
