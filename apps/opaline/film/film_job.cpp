#include "film/film_job.h"

#include <cassert>
#include <deque>
#include <exception>
#include <utility>
#include <vector>

#include "cli/frame_names.h"
#include "opaline/error.h"
#include "opaline/file.h"

namespace opaline::app {

namespace {

/// The frames that are submitted and not yet collected.
class FramesUnderWay {
 public:
  explicit FramesUnderWay(View& view) : view_(view) {}
  ~FramesUnderWay() {
    try {
      Frame unused;
      while (!numbers_.empty()) collect(unused);
    } catch (const std::exception&) {
      // Happens only on the way out, after an error; a failed device would report it again.
    }
  }
  FramesUnderWay(const FramesUnderWay&) = delete;
  FramesUnderWay& operator=(const FramesUnderWay&) = delete;

  std::size_t count() const { return numbers_.size(); }

  void submit(int number, const FrameOrder& order) {
    view_.submit(order);
    numbers_.push_back(number);
  }

  /// Collects the oldest frame and returns its number.
  int collect(Frame& frame) {
    const int number = numbers_.front();
    numbers_.pop_front();
    view_.collect(frame);
    return number;
  }

 private:
  View& view_;
  std::deque<int> numbers_;
};

}  // namespace

FilmJob::FilmJob(FilmOrder order)
    : order_(std::move(order)), output_(order_), next_(order_.frames.first) {
  const Target& target = order_.output;
  if (!isFilm(target.path)) requireWritable({fileOf(target.path, next_), target.existing});
}

FilmProgress FilmJob::progress() const {
  return {output_.written(), skipped_, order_.frames.count()};
}

void FilmJob::step(Renderer& renderer, std::size_t frames,
                   const std::function<void(const FilmProgress&)>& progress) {
  assert(!done_);
  if (!view_) view_.emplace(renderer, order_.options);
  const FrameOrder order{.aovs = {order_.aov}, .reuseLight = true};
  FramesUnderWay underWay(*view_);
  const auto showProgress = [&] {
    if (progress) progress(this->progress());
  };
  const auto collectOldest = [&] {
    Frame frame = output_.take();
    const int number = underWay.collect(frame);
    output_.push(number, std::move(frame));
    showProgress();
  };
  const auto collectAll = [&] {
    while (underWay.count() > 0) collectOldest();
  };
  const auto renderNext = [&] {
    const int frame = next_;
    next_ += order_.frames.step;
    if (isThere(order_, frame)) {
      ++skipped_;
      showProgress();
      return;
    }
    if (underWay.count() == View::framesInFlight) collectOldest();
    renderer.setTime({order_.frames.seconds(frame), order_.clip});
    if (order_.place) order_.place(renderer, frame);
    underWay.submit(frame, order);
    --frames;
  };
  try {
    while (frames > 0 && next_ <= order_.frames.last) renderNext();
  } catch (const Error&) {
    collectAll();
    output_.flush();  // keeps what was rendered before
    throw;
  }
  collectAll();
  if (next_ <= order_.frames.last) return;
  output_.finish();
  done_ = true;
  showProgress();
}

}  // namespace opaline::app
