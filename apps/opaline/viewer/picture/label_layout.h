#pragma once

#include <vector>

namespace opaline::app::viewer {

/// A rectangle of the window, pixels.
struct Box {
  float x = 0;
  float y = 0;
  float width = 0;
  float height = 0;

  bool meets(const Box& other) const;
};

/// Keeps what is written over the picture apart.
class LabelLayout {
 public:
  explicit LabelLayout(const Box& bounds) : bounds_(bounds) {}

  /// Something stands there already.
  void take(const Box& box) { taken_.push_back(box); }

  /// Within the bounds, as near as can be above where it is wanted, on nothing that was taken;
  /// takes that place. Where there is no room left it stays within the bounds.
  Box place(const Box& wanted);

 private:
  Box within(Box box) const;

  Box bounds_;
  std::vector<Box> taken_;
};

}  // namespace opaline::app::viewer
