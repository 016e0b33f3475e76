#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace opaline::app {

/// A progress bar on standard error, if that is a terminal. It disappears at the end.
class Progress {
 public:
  /// `unit` names in the singular what is counted, and `before` stands before all else.
  Progress(std::size_t total, bool quiet, std::string unit = "frame", std::string before = {});
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `skipped` of those that are done took no time.
  void show(std::size_t done, std::size_t skipped);

 private:
  using Clock = std::chrono::steady_clock;

  std::size_t total_;
  std::string unit_;
  std::string before_;
  bool shown_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point last_;
};

}  // namespace opaline::app
