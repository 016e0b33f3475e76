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

}  // namespace opaline::app
