#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "opaline/renderer.h"

namespace opaline::app {

/// Encodes and writes frames on threads of its own, while the next ones are rendered. Holds one
/// frame more than it has threads, and reuses their memory.
class FrameWriter {
 public:
  using Write = std::function<void(int number, const Frame& frame)>;

  /// With one worker the frames are written in the order of push().
  FrameWriter(std::size_t workers, Write write);
  /// Drops frames that are still waiting.
  ~FrameWriter();
  FrameWriter(const FrameWriter&) = delete;
  FrameWriter& operator=(const FrameWriter&) = delete;

  /// Waits for a free frame to be filled. Throws the error of an earlier frame.
  Frame take();
  void push(int number, Frame frame);
  /// Waits until all frames are written. Throws their first error.
  void finish();

  std::size_t written() const;

 private:
  struct Numbered {
    int number;
    Frame frame;
  };

  void work();
  void throwFailure();

  Write write_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Frame> free_;
  std::deque<Numbered> waiting_;
  std::size_t underWay_ = 0;
  std::size_t written_ = 0;
  bool ends_ = false;
  std::exception_ptr failure_;
  std::vector<std::thread> threads_;
};

}  // namespace opaline::app
