#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/command_line.h"

namespace opaline::app {

/// The extension in lower case, with its dot.
std::string extensionOf(const std::filesystem::path& file);

/// A file that is to be written, and the option that named it.
struct Output {
  std::string option;
  std::filesystem::path file;
};

/// Throws UsageError where an output is one of the files that are read, by whatever name.
void requireNoInput(const std::vector<Output>& outputs,
                    const std::vector<std::filesystem::path>& inputs);

/// "bear-2.png, as bear.png is there already" for a file that was to be called `wanted`.
std::string nameText(const std::filesystem::path& file, const std::filesystem::path& wanted);

/// A file to be written, whose extension is one of those. Throws UsageError for another extension.
std::filesystem::path readOutput(const Given& given, const std::vector<std::string>& extensions);

}  // namespace opaline::app
