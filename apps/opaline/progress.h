#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace opaline::app {

/// A bar on standard error while frames are made, where that is a terminal; gone at the end.
class Progress {
 public:
  Progress(std::size_t total, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `skipped` of the frames took no time.
  void show(std::size_t done, std::size_t skipped);

 private:
  using Clock = std::chrono::steady_clock;

  std::size_t total_;
  bool shown_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point last_;
};

}  // namespace opaline::app
