#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/mesh/point_tree.h"

namespace opaline::scene {

/// An ordered set of numbers below a limit, as levels of bits. A bit of a higher level tells
/// whether a word of the level below has any bit set.
class OrderedBits {
 public:
  static constexpr std::uint32_t none = ~0U;

  void reset(std::size_t limit);
  void insert(std::uint32_t number);
  void erase(std::uint32_t number);
  /// The smallest number that is at least `from`.
  std::uint32_t next(std::uint32_t from) const;

 private:
  std::vector<std::vector<std::uint64_t>> levels_;
  std::size_t count_ = 0;  ///< of levels in use
};

/// Cuts ears off a polygon that turns left: each time the next corner around it whose triangle
/// holds no other corner (Meisters 1975).
class Ears {
 public:
  /// Passes each triangle to `found`. False where no ear is left, or after `mostSteps`.
  template <typename Found>
  bool clip(std::span<const Double2> corners, std::size_t mostSteps, std::size_t& steps,
            const Found& found) {
    start(corners);
    for (std::size_t left = corners.size(); left > 3; --left) {
      const auto ear = nextEar(mostSteps, steps);
      if (ear[0] == ear[1]) return false;
      found(ear);
      cut(ear);
    }
    found(lastThree());
    return true;
  }

 private:
  using Corners = std::array<std::uint32_t, 3>;

  void start(std::span<const Double2> corners);
  /// Three equal corners where there is no ear.
  Corners nextEar(std::size_t mostSteps, std::size_t& steps);
  void cut(const Corners& ear);
  void judge(std::uint32_t corner);
  Corners lastThree() const;
  Corners around(std::uint32_t corner) const { return {before_[corner], corner, after_[corner]}; }

  struct Waiting {
    std::uint32_t corner;
    std::uint32_t next;
  };

  std::span<const Double2> corners_;
  std::uint32_t at_ = 0;
  std::vector<std::uint32_t> before_;
  std::vector<std::uint32_t> after_;
  OrderedBits hopeful_;  ///< corners that turn left and may have nothing inside
  PointTree tree_;
  /// By corner: the corner that lies in its triangle, and the first corner in whose triangle it
  /// lies itself. Some entries may be out of date.
  std::vector<std::uint32_t> waitsFor_;
  std::vector<std::uint32_t> firstWaiting_;
  std::vector<Waiting> waiting_;
};

}  // namespace opaline::scene
