#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "opaline/motion.h"
#include "scene/vector_math.h"

namespace opaline::scene {

/// A place among keys: between `from` and `to`, at `t` in [0, 1).
struct KeyPlace {
  std::size_t from = 0;
  std::size_t to = 0;
  double t = 0;
  double keySeconds = 0;  ///< from one key to the next
};

/// Finds a time among keys, which ascend and are at least one.
KeyPlace placeAmong(const std::vector<float>& keys, double seconds);

/// One track at one time, component by component (glTF 2.0, appendix C). The track must outlive it.
class TrackSample {
 public:
  TrackSample(const Track& track, double seconds);

  std::size_t width() const { return width_; }
  double interpolated(std::size_t component) const;
  Double3 vector() const { return {interpolated(0), interpolated(1), interpolated(2)}; }
  /// A quaternion of any length above 0: matrixFromParts() normalises it.
  std::array<double, 4> rotation() const;

 private:
  double part(std::size_t key, std::size_t which, std::size_t component) const;
  double value(std::size_t key, std::size_t component) const;
  std::array<double, 4> unitValue(std::size_t key) const;

  const Track& track_;
  std::size_t width_;
  KeyPlace place_;
  bool cubic_;
};

}  // namespace opaline::scene
