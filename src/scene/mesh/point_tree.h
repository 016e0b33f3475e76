#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace opaline::scene {

using Double2 = std::array<double, 2>;

/// Twice the area of a triangle, positive where its corners turn left.
inline double turn(const Double2& a, const Double2& b, const Double2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Points of the plane, halved again and again (Bentley 1975), from which single ones can be
/// removed.
class PointTree {
 public:
  void build(std::span<const Double2> points);

  void remove(std::uint32_t point);

  /// A point that was not removed and lies inside a left-turning triangle, or on its border. The
  /// corners do not count, nor do points at a corner. Adds the work to `steps`.
  std::optional<std::uint32_t> inside(const std::array<std::uint32_t, 3>& corners,
                                      std::size_t& steps) const;

 private:
  /// The box of those points of a range that were not removed, and their number.
  struct Node {
    Double2 low;
    Double2 high;
    std::uint32_t left;
  };
  struct Range {
    std::size_t node, begin, end;

    bool isLeaf() const { return end - begin <= 16; }
    Range half(std::size_t which) const;
  };

  static const Node empty;
  static Node together(const Node& a, const Node& b);

  void build(const Range& range);
  Node nodeOf(const Range& range) const;
  void remove(const Range& range, std::size_t place);
  std::optional<std::uint32_t> inside(const Range& range,
                                      const std::array<std::uint32_t, 3>& corners,
                                      std::size_t& steps) const;
  bool isOutside(const Node& node, const std::array<std::uint32_t, 3>& corners) const;
  bool contains(const std::array<std::uint32_t, 3>& corners, std::uint32_t point) const;

  std::span<const Double2> points_;
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t> placeOf_;  ///< index in order_; none if removed
  std::vector<Node> nodes_;             ///< the halves of node i are 2i + 1 and 2i + 2
};

}  // namespace opaline::scene
