#include "renderer/timing.h"

#include <algorithm>

namespace opaline {

namespace {

double medianAfterFirst(const std::vector<double>& values) {
  if (values.empty()) return 0;
  std::vector<double> sorted(values.begin() + (values.size() > 1 ? 1 : 0), values.end());
  std::sort(sorted.begin(), sorted.end());
  const std::size_t middle = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
}

}  // namespace

void FrameTimes::add(double frameMilliseconds, const std::vector<gpu::PassTiming>& passes) {
  frames_.push_back(frameMilliseconds);
  for (const gpu::PassTiming& pass : passes) {
    auto name = std::find(names_.begin(), names_.end(), pass.name);
    if (name == names_.end()) {
      name = names_.insert(name, pass.name);
      times_.emplace_back();
    }
    times_[static_cast<std::size_t>(name - names_.begin())].push_back(pass.milliseconds);
  }
}

double FrameTimes::frameMilliseconds() const {
  return medianAfterFirst(frames_);
}

std::vector<PassTime> FrameTimes::passes() const {
  std::vector<PassTime> passes;
  for (std::size_t i = 0; i < names_.size(); ++i)
    passes.push_back({names_[i], medianAfterFirst(times_[i])});
  return passes;
}

}  // namespace opaline
