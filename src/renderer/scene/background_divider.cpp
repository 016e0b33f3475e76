#include "renderer/scene/background_divider.h"

#include <chrono>

namespace opaline {

void BackgroundDivider::want(const DivisionOrder& order, const scene::MergedMesh& merged,
                             const Within& within) {
  merged_ = &merged;
  within_ = &within;
  const bool there = next_ ? *next_ == order : future_.valid() && present_ == order;
  if (there) return;
  next_ = order;
  if (!future_.valid()) start();
}

void BackgroundDivider::start() {
  present_ = *next_;
  next_.reset();
  future_ = std::async(std::launch::async, [merged = merged_, within = within_, order = present_] {
    return divide(*merged, order, *within);
  });
}

std::optional<Division> BackgroundDivider::take(bool patient) {
  std::optional<Division> done;
  while (future_.valid()) {
    using namespace std::chrono_literals;
    if (!patient && future_.wait_for(0s) != std::future_status::ready) break;
    done = future_.get();
    if (next_) start();
  }
  return done;
}

void BackgroundDivider::forget() {
  next_.reset();
  if (future_.valid()) future_.wait();
  future_ = {};
}

}  // namespace opaline
