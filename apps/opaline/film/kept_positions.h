#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <vector>

#include "opaline/types.h"

namespace opaline::app {

/// Keeps positions that one reader has read from numbered files and another will need: the camera's
/// place depends on all frames of a film, so they are read before the first is rendered.
/// Thread-safe.
class KeptPositions {
 public:
  static constexpr std::size_t usualBytes = std::size_t{1} << 30;

  explicit KeptPositions(std::size_t mostBytes = usualBytes) : mostBytes_(mostBytes) {}

  /// Does nothing where they do not fit.
  void keep(int number, std::vector<Vec3> positionsMm);
  /// Hands out positions that were kept, and forgets them. False where none were.
  bool take(int number, std::vector<Vec3>& positionsMm);

 private:
  std::mutex mutex_;
  std::map<int, std::vector<Vec3>> positions_;
  std::size_t bytes_ = 0;
  std::size_t mostBytes_;
};

}  // namespace opaline::app
