#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "gpu/command_list.h"
#include "opaline/renderer.h"

namespace opaline {

/// Collects the times of frames and gives medians over the last 1024. The first frame, in which
/// drivers still compile shaders, counts only when it is the only one. After the first frames it
/// allocates nothing.
class FrameTimes {
 public:
  void add(double frameMilliseconds, const std::vector<gpu::PassTiming>& passes);
  void clear() { *this = {}; }
  bool empty() const { return names_.empty(); }

  double frameMilliseconds() const;
  std::vector<PassTime> passes() const;

 private:
  static constexpr std::size_t kept = 1024;

  /// The last values, without the very first.
  struct Series {
    double first = 0;
    std::size_t count = 0;
    std::vector<double> rest;

    void add(double value);
    double median() const;
  };

  Series frames_;
  std::vector<std::string> names_;
  std::vector<Series> times_;  // by pass
};

}  // namespace opaline
