#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace opaline::app {

/// The path at which the shell would find a program; none where it would not.
std::optional<std::filesystem::path> findProgram(const std::string& name);

/// A program that reads what we write to it, and may answer. It is killed when this object is
/// destroyed, and when this program is interrupted.
class ChildProcess {
 public:
  /// What happens to its standard output.
  enum class Output { Dropped, Kept };

  /// Throws Error when it cannot be started.
  ChildProcess(const std::filesystem::path& program, std::vector<std::string> arguments,
               Output output = Output::Dropped);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// False when the program no longer reads.
  bool write(std::string_view bytes) const;

  /// Ends its input and waits for its end. True if it reports success.
  bool finish();

  /// Whether finish() would have to wait.
  bool isRunning() const;
  /// Its exit status, after finish(); none where it was killed.
  std::optional<int> exitStatus() const { return status_; }
  /// Up to `mostBytes` of its standard output, where that is kept.
  std::string output(std::size_t mostBytes) const;

  /// May be called while another thread writes, whose write() then fails.
  void kill();

  /// The last line of what it wrote to its standard error that is more than the beginning of a
  /// sentence, as ffmpeg has them before "--"; call after finish().
  std::string lastWords() const;

 private:
  void closeInput();
  void closeFiles();

  pid_t id_ = -1;
  int input_ = -1;
  int errors_ = -1;
  int output_ = -1;
  std::optional<int> status_;
};

/// Kills all children and lets none be started afterwards: whoever tries waits for ever.
void abandonChildProcesses();

}  // namespace opaline::app
