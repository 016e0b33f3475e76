#pragma once

#include <functional>
#include <future>
#include <vector>

#include "opaline/types.h"

namespace opaline::app {

/// Positions from numbered files. While those of one number are in use, another thread reads those
/// a step ahead.
class PositionsAhead {
 public:
  /// Must be callable on another thread.
  using Read = std::function<void(int number, std::vector<Vec3>& positionsMm)>;

  PositionsAhead(int lastNumber, int step, Read read);

  /// Throws what reading threw.
  const std::vector<Vec3>& of(int number);

 private:
  std::vector<Vec3> readInto(int number, std::vector<Vec3> memory) const;
  void readAhead(int number);

  int lastNumber_;
  int step_;
  Read read_;
  std::vector<Vec3> current_;
  std::vector<Vec3> spare_;
  int aheadNumber_ = -1;
  std::future<std::vector<Vec3>> ahead_;
};

}  // namespace opaline::app
