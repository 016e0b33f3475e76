#include "lab/frame_medians.h"

#include <algorithm>
#include <cstddef>

namespace opaline::app {

double medianOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

void FrameMedians::add(const Frame& frame) {
  if (!std::exchange(warm_, true)) return;
  frames_.push_back(frame.milliseconds);
  passes_.resize(std::max(passes_.size(), frame.passes.size()));
  for (std::size_t i = 0; i < frame.passes.size(); ++i) {
    passes_[i].first = frame.passes[i].name;
    passes_[i].second.push_back(frame.passes[i].milliseconds);
  }
}

double FrameMedians::passMilliseconds(std::initializer_list<std::string_view> names) const {
  double sum = 0;
  for (const auto& [name, milliseconds] : passes_)
    if (std::find(names.begin(), names.end(), name) != names.end()) sum += medianOf(milliseconds);
  return sum;
}

void renderFrame(View& view, const FrameOrder& order, Frame& done) {
  view.submit(order);
  view.collect(done);
}

}  // namespace opaline::app
