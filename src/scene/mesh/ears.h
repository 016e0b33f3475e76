#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/mesh/point_tree.h"

namespace opaline::scene {

/// A set of numbers below a limit, in order: words of bits, above them words of which bits are set
/// where a word below has any.
class OrderedBits {
 public:
  static constexpr std::uint32_t none = ~0U;

  void reset(std::size_t limit);
  void insert(std::uint32_t number);
  void erase(std::uint32_t number);
  /// The least that is not below `from`.
  std::uint32_t next(std::uint32_t from) const;

 private:
  std::vector<std::vector<std::uint64_t>> levels_;
  std::size_t count_ = 0;  ///< of levels in use
};

/// Cuts corners off a polygon that turns left, each time the next around it whose triangle has no
/// other corner inside (Meisters 1975).
class Ears {
 public:
  /// Hands each triangle to `found`; false where no ear is left, or `mostSteps` are done.
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
  /// Three times the same where there is none.
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
  OrderedBits hopeful_;  ///< turn left, and nothing is known to lie inside
  PointTree tree_;
  /// By corner: what lies in its triangle, and the first of those in whose triangles it lies. Some
  /// of these wait for it no more.
  std::vector<std::uint32_t> waitsFor_;
  std::vector<std::uint32_t> firstWaiting_;
  std::vector<Waiting> waiting_;
};

}  // namespace opaline::scene
