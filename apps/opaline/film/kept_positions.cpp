#include "film/kept_positions.h"

#include <utility>

namespace opaline::app {

void KeptPositions::keep(int number, std::vector<Vec3> positionsMm) {
  const std::size_t bytes = positionsMm.size() * sizeof(Vec3);
  const std::scoped_lock lock(mutex_);
  if (bytes_ + bytes > mostBytes_) return;
  if (positions_.try_emplace(number, std::move(positionsMm)).second) bytes_ += bytes;
}

bool KeptPositions::take(int number, std::vector<Vec3>& positionsMm) {
  const std::scoped_lock lock(mutex_);
  auto kept = positions_.extract(number);
  if (kept.empty()) return false;
  positionsMm = std::move(kept.mapped());
  bytes_ -= positionsMm.size() * sizeof(Vec3);
  return true;
}

}  // namespace opaline::app
