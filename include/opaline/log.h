#pragma once

#include <functional>
#include <string_view>

namespace opaline {

/// How much a message matters.
enum class LogLevel { Debug, Note, Warning };

/// Receives all messages of the library; the library itself prints nothing. A message is one
/// sentence without a line break at its end. Called on the thread that called the library.
using LogCallback = std::function<void(LogLevel, std::string_view message)>;

}  // namespace opaline
