#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <vector>

#include "opaline/types.h"

namespace opaline::app {

/// Positions of numbered files that one reader has read and another will want: the camera's place
/// depends on all frames of a film, so they are needed before the first is rendered. May be used by
/// several threads at once.
class KeptPositions {
 public:
  static constexpr std::size_t usualBytes = std::size_t{1} << 30;

  explicit KeptPositions(std::size_t mostBytes = usualBytes) : mostBytes_(mostBytes) {}

  /// Does nothing where there is no room for them.
  void keep(int number, std::vector<Vec3> positionsMm);
  /// Whether they were kept; from now on they are not.
  bool take(int number, std::vector<Vec3>& positionsMm);

 private:
  std::mutex mutex_;
  std::map<int, std::vector<Vec3>> positions_;
  std::size_t bytes_ = 0;
  std::size_t mostBytes_;
};

}  // namespace opaline::app
