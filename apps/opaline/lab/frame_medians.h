#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "opaline/view.h"

namespace opaline::app {

/// Of one value or more.
double medianOf(std::vector<double> values);

/// Times of one kind of frame. The first, in which drivers still compile shaders, does not count.
class FrameMedians {
 public:
  void add(const Frame& frame);

  double frameMilliseconds() const { return medianOf(frames_); }
  /// Of all passes of these names together; 0 where there are none.
  double passMilliseconds(std::initializer_list<std::string_view> names) const;

 private:
  bool warm_ = false;
  std::vector<double> frames_;
  std::vector<std::pair<std::string, std::vector<double>>> passes_;  ///< by their place
};

/// Renders a frame and waits for it.
void renderFrame(View& view, const FrameOrder& order, Frame& done);

}  // namespace opaline::app
