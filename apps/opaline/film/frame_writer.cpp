#include "film/frame_writer.h"

#include <utility>

namespace opaline::app {

FrameWriter::FrameWriter(std::size_t workers, Write write)
    : write_(std::move(write)), free_(workers + 1) {
  for (std::size_t i = 0; i < workers; ++i) threads_.emplace_back([this] { work(); });
}

FrameWriter::~FrameWriter() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
    waiting_.clear();
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

Frame FrameWriter::take() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return failure_ || !free_.empty(); });
  throwFailure();
  Frame frame = std::move(free_.back());
  free_.pop_back();
  return frame;
}

void FrameWriter::push(int number, Frame frame) {
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back({number, std::move(frame)});
  }
  changed_.notify_all();
}

void FrameWriter::finish() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return failure_ || (waiting_.empty() && underWay_ == 0); });
  throwFailure();
}

std::size_t FrameWriter::written() const {
  const std::lock_guard lock(mutex_);
  return written_;
}

void FrameWriter::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return ends_ || (!failure_ && !waiting_.empty()); });
    if (ends_) return;
    Numbered next = std::move(waiting_.front());
    waiting_.pop_front();
    ++underWay_;
    lock.unlock();
    std::exception_ptr failure;
    try {
      write_(next.number, next.frame);
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    --underWay_;
    if (!failure) ++written_;
    if (failure && !failure_) failure_ = failure;
    free_.push_back(std::move(next.frame));
    changed_.notify_all();
  }
}

void FrameWriter::throwFailure() {
  if (failure_) std::rethrow_exception(failure_);
}

}  // namespace opaline::app
