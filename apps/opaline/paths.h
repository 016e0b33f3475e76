#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "command_line.h"

namespace opaline::app {

/// The extension in lower case, with its dot.
std::string extensionOf(const std::filesystem::path& file);

/// A file to be written, whose extension is one of those. Throws UsageError for another extension.
std::filesystem::path readOutput(const Given& given, const std::vector<std::string>& extensions);

/// Throws Error now, before any work, when the file could not be written later; see
/// core::requireWritable. Refuses what is there and no regular file, since it would be replaced.
void requireWritableFile(const std::filesystem::path& file);

}  // namespace opaline::app
