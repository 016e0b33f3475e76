#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/command_line.h"

namespace opaline::app {

/// The extension in lower case, with its dot.
std::string extensionOf(const std::filesystem::path& file);

/// A file to be written, and the option that named it.
struct Output {
  std::string option;
  std::filesystem::path file;
};

/// Throws UsageError where an output is one of the files that are read, under any name.
void requireNoInput(const std::vector<Output>& outputs,
                    const std::vector<std::filesystem::path>& inputs);

/// Text such as "bear-2.png, because bear.png exists", for a file that should have been called
/// `wanted`.
std::string nameText(const std::filesystem::path& file, const std::filesystem::path& wanted);

/// A file to be written, with one of those extensions. Throws UsageError for another extension.
std::filesystem::path readOutput(const Given& given, const std::vector<std::string>& extensions);

}  // namespace opaline::app
