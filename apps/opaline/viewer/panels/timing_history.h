#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "opaline/renderer.h"

namespace opaline::app::viewer {

/// GPU times of the passes in the last frames.
class TimingHistory {
 public:
  static constexpr std::size_t kept = 120;

  void add(const Frame& frame);
  void clear();

  std::size_t frames() const { return count_; }
  /// In the order in which they first ran.
  const std::vector<std::string>& passes() const { return names_; }
  /// Milliseconds of every pass in a frame, 0 being the oldest; 0 for a pass that did not run.
  std::span<const double> milliseconds(std::size_t frame) const;
  double largestTotal() const;
  /// The median of one pass over the frames kept.
  double median(std::size_t pass) const;
  double medianTotal() const;

 private:
  std::vector<std::string> names_;
  std::array<std::vector<double>, kept> rows_;
  std::size_t next_ = 0;
  std::size_t count_ = 0;
};

}  // namespace opaline::app::viewer
