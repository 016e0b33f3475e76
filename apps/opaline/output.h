#pragma once

#include <string_view>

#include "opaline/log.h"

namespace opaline::app {

/// Opens what the caller closed of the three standard streams, so that no picture is ever mistaken
/// for one of them, and lets a closed pipe be no signal.
void guardStandardStreams();

/// Writes to standard output. Throws Error when it cannot be written; a reader that has left is
/// no error.
void printOut(std::string_view text);

/// One line on standard error; control characters become '?', as they may come from file names.
void printError(std::string_view sentence);

/// Notes on standard error, unless `quiet`.
LogCallback noteTaker(bool quiet);

}  // namespace opaline::app
