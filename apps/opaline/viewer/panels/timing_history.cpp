#include "viewer/panels/timing_history.h"

#include <algorithm>
#include <numeric>

namespace opaline::app::viewer {

namespace {

double middleOf(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double sum(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

}  // namespace

void TimingHistory::add(const Frame& frame) {
  std::vector<double>& row = rows_[next_];
  row.assign(names_.size(), 0);
  for (const PassTime& pass : frame.passes) {
    auto found = std::find(names_.begin(), names_.end(), pass.name);
    if (found == names_.end()) {
      names_.push_back(pass.name);
      for (std::vector<double>& each : rows_) each.resize(names_.size(), 0);
      found = names_.end() - 1;
    }
    row[static_cast<std::size_t>(found - names_.begin())] += pass.milliseconds;
  }
  next_ = (next_ + 1) % kept;
  count_ = std::min(count_ + 1, kept);
}

void TimingHistory::clear() {
  *this = {};
}

std::span<const double> TimingHistory::milliseconds(std::size_t frame) const {
  return rows_[(next_ + kept - count_ + frame) % kept];
}

double TimingHistory::largestTotal() const {
  double largest = 0;
  for (std::size_t i = 0; i < count_; ++i) largest = std::max(largest, sum(milliseconds(i)));
  return largest;
}

double TimingHistory::median(std::size_t pass) const {
  std::vector<double> values;
  for (std::size_t i = 0; i < count_; ++i) values.push_back(milliseconds(i)[pass]);
  return middleOf(std::move(values));
}

double TimingHistory::medianTotal() const {
  std::vector<double> values;
  for (std::size_t i = 0; i < count_; ++i) values.push_back(sum(milliseconds(i)));
  return middleOf(std::move(values));
}

}  // namespace opaline::app::viewer
