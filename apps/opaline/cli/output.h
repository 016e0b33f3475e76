#pragma once

#include <cstddef>
#include <exception>
#include <functional>
#include <string_view>

#include "opaline/log.h"

namespace opaline::app {

/// Opens what the caller closed of the three standard streams, so that no picture is ever mistaken
/// for one of them, and lets a closed pipe be an error instead of a signal.
void guardStandardStreams();

/// Whoever read standard output wants no more, as in `opaline media | head -1`: the program ends,
/// but nobody is told.
class ReaderLeft : public std::exception {};

/// Writes to standard output. Throws ReaderLeft, or Error when not all of it arrives.
void printOut(std::string_view text);

/// One line on standard error; control characters become '?', as they may come from file names.
void printError(std::string_view sentence);

/// Notes on standard error, unless `quiet`.
LogCallback noteTaker(bool quiet);

/// Width of the terminal that standard error is; 0 when it is none.
std::size_t statusColumns();

/// Shows a line on that terminal in place of the one before. Errors and notes take its place too.
void showStatus(std::string_view line);
void clearStatus();

/// Shows what is under way there, unless `quiet` or there is no terminal.
using StatusCallback = std::function<void(std::string_view)>;
StatusCallback statusTaker(bool quiet);

}  // namespace opaline::app
