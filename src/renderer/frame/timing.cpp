#include "renderer/frame/timing.h"

#include <algorithm>

namespace opaline {

void FrameTimes::Series::add(double value) {
  if (count++ == 0) {
    first = value;
    rest.reserve(kept);
  } else if (rest.size() < kept) {
    rest.push_back(value);
  } else {
    rest[(count - 2) % kept] = value;
  }
}

double FrameTimes::Series::median() const {
  if (rest.empty()) return first;
  std::vector<double> sorted = rest;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t middle = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
}

void FrameTimes::add(double frameMilliseconds, const std::vector<gpu::PassTiming>& passes) {
  frames_.add(frameMilliseconds);
  for (const gpu::PassTiming& pass : passes) {
    auto name = std::find(names_.begin(), names_.end(), pass.name);
    if (name == names_.end()) {
      name = names_.insert(name, pass.name);
      times_.emplace_back();
    }
    times_[static_cast<std::size_t>(name - names_.begin())].add(pass.milliseconds);
  }
}

double FrameTimes::frameMilliseconds() const {
  return frames_.median();
}

std::vector<PassTime> FrameTimes::passes() const {
  std::vector<PassTime> passes;
  for (std::size_t i = 0; i < names_.size(); ++i) passes.push_back({names_[i], times_[i].median()});
  return passes;
}

}  // namespace opaline
