#pragma once

#include <functional>
#include <stdexcept>
#include <stop_token>

namespace opaline::reference {

/// Thrown by work that was asked to stop before it was done.
class Stopped : public std::runtime_error {
 public:
  Stopped() : std::runtime_error("stopped") {}
};

inline void throwIfStopped(const std::stop_token& stop) {
  if (stop.stop_requested()) throw Stopped();
}

/// Runs `work` and the parallel work in it on at most that many threads, including the calling one;
/// 0: as many as there are cores.
void onThreads(int threads, const std::function<void()>& work);

}  // namespace opaline::reference
