#include "cli/output.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <string>

#include "cli/field_names.h"
#include "opaline/error.h"

namespace opaline::app {

namespace {

std::atomic<bool> statusShown = false;

void toStandardError(std::string_view prefix, std::string_view sentence) {
  std::string line = fmt::format("{}{}", prefix, withOptionNames(sentence));
  std::replace_if(
      line.begin(), line.end(),
      [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
  if (line.find_last_of(".!?") != line.size() - 1) line += '.';
  line += '\n';
  clearStatus();
  // If standard error itself fails, nobody can be told.
  static_cast<void>(std::fwrite(line.data(), 1, line.size(), stderr));
}

}  // namespace

void guardStandardStreams() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow then fails as on a full disk
  for (int stream = 0; stream < 3; ++stream) {
    if (::fcntl(stream, F_GETFD) == -1 && errno == EBADF) {
      // A closed standard output is opened so that it cannot be written: lost output is then
      // reported.
      const int opened = ::open("/dev/null", stream == 2 ? O_WRONLY : O_RDONLY);
      if (opened != stream && opened >= 0) ::close(opened);
    }
  }
}

void printOut(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    if (errno == EPIPE) throw ReaderLeft();
    throw Error(fmt::format("cannot write to standard output: {}", std::strerror(errno)));
  }
}

void printError(std::string_view sentence) {
  toStandardError("opaline: ", sentence);
}

std::size_t statusColumns() {
  constexpr std::size_t usual = 80;
  winsize size{};
  if (isatty(STDERR_FILENO) == 0) return 0;
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return usual;
  return size.ws_col;
}

void showStatus(std::string_view line) {
  const std::string text = fmt::format("\r{}\x1b[K", line);
  statusShown = true;
  static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
}

void clearStatus() {
  if (statusShown.exchange(false)) static_cast<void>(std::fputs("\r\x1b[K", stderr));
}

StatusCallback statusTaker(bool quiet) {
  return [quiet](std::string_view line) {
    if (!quiet && statusColumns() > 0) showStatus(line);
  };
}

LogCallback noteTaker(bool quiet) {
  return [quiet](LogLevel level, std::string_view message) {
    if (level == LogLevel::Warning) {
      toStandardError("warning: ", message);
    } else if (level == LogLevel::Note && !quiet) {
      toStandardError("note: ", message);
    }
  };
}

}  // namespace opaline::app
