#pragma once

#include <string>
#include <vector>

#include "gpu/command_list.h"
#include "opaline/renderer.h"

namespace opaline {

/// Collects the times of frames and gives medians. The first frame, in which drivers still compile
/// shaders, counts only when it is the only one.
class FrameTimes {
 public:
  void add(double frameMilliseconds, const std::vector<gpu::PassTiming>& passes);

  double frameMilliseconds() const;
  std::vector<PassTime> passes() const;

 private:
  std::vector<double> frames_;
  std::vector<std::string> names_;
  std::vector<std::vector<double>> times_;  // by pass, by frame
};

}  // namespace opaline
