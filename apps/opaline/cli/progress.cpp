#include "cli/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/output.h"

namespace opaline::app {

namespace {

std::string clockText(double seconds) {
  const auto whole = static_cast<long long>(std::ceil(std::min(seconds, 3.6e8)));
  const long long hours = whole / 3600;
  const long long minutes = whole / 60 % 60;
  return hours > 0 ? fmt::format("{}:{:02}:{:02}", hours, minutes, whole % 60)
                   : fmt::format("{}:{:02}", minutes, whole % 60);
}

std::string barText(double share, std::size_t columns) {
  constexpr std::size_t least = 8;
  if (columns < least) return {};
  const std::size_t inside = columns - 3;
  const auto full = static_cast<std::size_t>(share * static_cast<double>(inside));
  return fmt::format(" [{}{}]", std::string(full, '='), std::string(inside - full, ' '));
}

}  // namespace

Progress::Progress(std::size_t total, bool quiet, std::string unit, std::string before)
    : total_(total),
      unit_(std::move(unit)),
      before_(std::move(before)),
      shown_(!quiet && statusColumns() > 0) {}

Progress::~Progress() {
  if (shown_) clearStatus();
}

void Progress::show(std::size_t done, std::size_t skipped) {
  constexpr std::chrono::milliseconds pause(100);
  const Clock::time_point now = Clock::now();
  if (!shown_ || (done < total_ && now - last_ < pause)) return;
  last_ = now;
  const double seconds = std::chrono::duration<double>(now - begin_).count();
  const std::size_t made = done - std::min(done, skipped);
  std::string right;
  if (made > 0 && seconds > 0) {
    const double perSecond = static_cast<double>(made) / seconds;
    right = fmt::format(" {:.3g} {}s/s, {} left", perSecond, unit_,
                        clockText(static_cast<double>(total_ - done) / perSecond));
  }
  const std::string left = fmt::format("{}{} {}/{}", before_, unit_, done, total_);
  // One column stays free: writing the last one may make a terminal begin a new line.
  const std::size_t columns = std::max<std::size_t>(statusColumns(), 1) - 1;
  const std::size_t taken = left.size() + right.size();
  const double share =
      static_cast<double>(done) / static_cast<double>(std::max<std::size_t>(total_, 1));
  const std::string bar = columns > taken ? barText(share, columns - taken) : "";
  showStatus((left + bar + right).substr(0, columns));
}

}  // namespace opaline::app
