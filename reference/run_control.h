#pragma once

#include <functional>
#include <stdexcept>
#include <stop_token>

namespace opaline::reference {

/// Thrown by what was asked to stop before it was done.
class Stopped : public std::runtime_error {
 public:
  Stopped() : std::runtime_error("stopped") {}
};

inline void throwIfStopped(const std::stop_token& stop) {
  if (stop.stop_requested()) throw Stopped();
}

/// Runs `work` and what it divides among threads on at most that many of them, the calling one
/// among these; 0: as many as there are cores.
void onThreads(int threads, const std::function<void()>& work);

}  // namespace opaline::reference
