#pragma once

#include <vector>

namespace opaline::app::viewer {

/// A rectangle of the window, in pixels.
struct Box {
  float x = 0;
  float y = 0;
  float width = 0;
  float height = 0;

  bool meets(const Box& other) const;
};

/// Keeps labels over the picture apart.
class LabelLayout {
 public:
  explicit LabelLayout(const Box& bounds) : bounds_(bounds) {}

  /// Reserves a place that is used already.
  void take(const Box& box) { taken_.push_back(box); }

  /// Takes a place within the bounds that overlaps nothing: the wanted one, or the nearest above
  /// it. Where there is no room left, it only stays within the bounds.
  Box place(const Box& wanted);

 private:
  Box within(Box box) const;

  Box bounds_;
  std::vector<Box> taken_;
};

}  // namespace opaline::app::viewer
