#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "opaline/view.h"

namespace opaline::app {

/// The median of one or more values.
double medianOf(std::vector<double> values);

/// Times of one kind of frame. The first frame does not count, since drivers still compile shaders
/// then.
class FrameMedians {
 public:
  void add(const Frame& frame);

  double frameMilliseconds() const { return medianOf(frames_); }
  /// The sum over all passes of these names; 0 where there are none.
  double passMilliseconds(std::initializer_list<std::string_view> names) const;

 private:
  bool warm_ = false;
  std::vector<double> frames_;
  std::vector<std::pair<std::string, std::vector<double>>> passes_;  ///< in their order
};

/// Renders a frame and waits for it.
void renderFrame(View& view, const FrameOrder& order, Frame& done);

}  // namespace opaline::app
