#include "cli/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <set>

#include "opaline/error.h"

namespace opaline::app {

namespace fs = std::filesystem;

namespace {

/// All child processes. Each is started and reaped under the lock, so that an id in the set always
/// belongs to a child of ours.
struct Children {
  std::mutex mutex;
  std::set<pid_t> ids;
};

Children& children() {
  // Never destroyed: a thread may wait for a signal until the very end.
  static Children& all = *new Children;
  return all;
}

/// Waits for the end of a child without reaping it.
void awaitEnd(pid_t id) {
  siginfo_t info{};
  while (waitid(P_PID, static_cast<id_t>(id), &info, WEXITED | WNOWAIT) != 0 && errno == EINTR) {
  }
}

/// Gives the child its streams, default signals as a shell would, and its own process group: a key
/// that interrupts us must not make the child finish a file that nobody wants.
class SpawnSettings {
 public:
  /// A negative output is dropped.
  SpawnSettings(int input, int output, int errors) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_adddup2(&actions_, input, STDIN_FILENO);
    if (output < 0) {
      posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    } else {
      posix_spawn_file_actions_adddup2(&actions_, output, STDOUT_FILENO);
    }
    posix_spawn_file_actions_adddup2(&actions_, errors, STDERR_FILENO);
    posix_spawnattr_init(&attributes_);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes_, &none);
    sigset_t usual;
    sigemptyset(&usual);
    sigaddset(&usual, SIGPIPE);
    posix_spawnattr_setsigdefault(&attributes_, &usual);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(
        &attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  }
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  int spawn(pid_t& id, const fs::path& program, const std::vector<char*>& arguments) const {
    return posix_spawn(&id, program.c_str(), &actions_, &attributes_, arguments.data(), environ);
  }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

}  // namespace

std::optional<fs::path> findProgram(const std::string& name) {
  const char* const variable = std::getenv("PATH");
  const std::string folders = variable == nullptr ? "/usr/local/bin:/usr/bin:/bin" : variable;
  for (std::size_t begin = 0; begin <= folders.size();) {
    const std::size_t end = std::min(folders.find(':', begin), folders.size());
    fs::path file = fs::path(folders.substr(begin, end - begin)) / name;
    std::error_code error;
    if (fs::is_regular_file(file, error) && access(file.c_str(), X_OK) == 0) return file;
    begin = end + 1;
  }
  return std::nullopt;
}

ChildProcess::ChildProcess(const fs::path& program, std::vector<std::string> arguments,
                           Output output) {
  std::array<int, 2> ends{-1, -1};
  const bool kept = output == Output::Kept;
  errors_ = memfd_create("errors of a child", MFD_CLOEXEC);
  if (kept) output_ = memfd_create("output of a child", MFD_CLOEXEC);
  if (errors_ < 0 || (kept && output_ < 0) || pipe2(ends.data(), O_CLOEXEC) != 0) {
    const int reason = errno;
    closeFiles();
    throw Error(fmt::format("Cannot start {}: {}.", program.string(), std::strerror(reason)));
  }
  input_ = ends[1];
  std::string name = program.string();
  std::vector<char*> pointers{name.data()};
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  int failure = 0;
  {
    const std::lock_guard lock(children().mutex);
    failure = SpawnSettings(ends[0], output_, errors_).spawn(id_, program, pointers);
    if (failure == 0) children().ids.insert(id_);
  }
  close(ends[0]);
  if (failure == 0) return;
  closeInput();
  closeFiles();
  throw Error(fmt::format("Cannot start {}: {}.", program.string(), std::strerror(failure)));
}

ChildProcess::~ChildProcess() {
  kill();
  finish();
  closeFiles();
}

bool ChildProcess::write(std::string_view bytes) const {
  while (!bytes.empty()) {
    const ssize_t count = ::write(input_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

bool ChildProcess::finish() {
  closeInput();
  if (id_ < 0) return false;
  awaitEnd(id_);
  const std::lock_guard lock(children().mutex);
  int status = 0;
  const bool reaped = waitpid(id_, &status, 0) == id_;
  children().ids.erase(id_);
  id_ = -1;
  if (reaped && WIFEXITED(status)) status_ = WEXITSTATUS(status);
  return status_ == 0;
}

bool ChildProcess::isRunning() const {
  if (id_ < 0) return false;
  siginfo_t info{};
  info.si_pid = 0;
  const bool known = waitid(P_PID, static_cast<id_t>(id_), &info, WEXITED | WNOWAIT | WNOHANG) == 0;
  return known && info.si_pid == 0;
}

std::string ChildProcess::output(std::size_t mostBytes) const {
  if (output_ < 0) return {};
  const off_t end = lseek(output_, 0, SEEK_END);
  std::string text(std::min(mostBytes, static_cast<std::size_t>(std::max<off_t>(end, 0))), '\0');
  const ssize_t count = pread(output_, text.data(), text.size(), 0);
  text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  return text;
}

void ChildProcess::kill() {
  const std::lock_guard lock(children().mutex);
  if (id_ > 0) ::kill(id_, SIGKILL);
}

std::string ChildProcess::lastWords() const {
  constexpr off_t most = 4096;
  const off_t end = lseek(errors_, 0, SEEK_END);
  std::string text(static_cast<std::size_t>(std::clamp<off_t>(end, 0, most)), '\0');
  const ssize_t count =
      pread(errors_, text.data(), text.size(), end - static_cast<off_t>(text.size()));
  text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  std::string line;
  do {
    text.resize(text.find_last_not_of("\r\n ") + 1);
    line = text.substr(text.find_last_of("\r\n") + 1);
    text.resize(text.size() - line.size());
  } while (line.ends_with("--"));
  return line;
}

void ChildProcess::closeInput() {
  if (input_ >= 0) close(input_);
  input_ = -1;
}

void ChildProcess::closeFiles() {
  for (int* file : {&errors_, &output_}) {
    if (*file >= 0) close(*file);
    *file = -1;
  }
}

void abandonChildProcesses() {
  children().mutex.lock();  // never unlocked
  for (const pid_t id : children().ids) {
    ::kill(id, SIGKILL);
    awaitEnd(id);
  }
}

}  // namespace opaline::app
