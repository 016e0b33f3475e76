#pragma once

#include <cstddef>
#include <exception>
#include <functional>
#include <string_view>

#include "opaline/log.h"

namespace opaline::app {

/// Opens those of the three standard streams that the caller closed, so that no picture is ever
/// mistaken for one of them. Makes a closed pipe an error instead of a signal.
void guardStandardStreams();

/// The reader of standard output has left, as in `opaline media | head -1`: the program ends
/// silently.
class ReaderLeft : public std::exception {};

/// Writes to standard output. Throws ReaderLeft, or Error when not all of it arrives.
void printOut(std::string_view text);

/// Prints one line on standard error. Control characters, which may come from file names, become
/// '?'.
void printError(std::string_view sentence);

/// A log that prints on standard error, and drops notes if `quiet`.
LogCallback noteTaker(bool quiet);

/// Width of the terminal on standard error; 0 if it is not a terminal.
std::size_t statusColumns();

/// Shows a line on that terminal in place of the previous one. Errors and notes replace it too.
void showStatus(std::string_view line);
void clearStatus();

/// Shows on the terminal what is under way, unless `quiet` or there is no terminal.
using StatusCallback = std::function<void(std::string_view)>;
StatusCallback statusTaker(bool quiet);

}  // namespace opaline::app
