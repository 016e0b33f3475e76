#include "viewer/picture/label_layout.h"

#include <algorithm>

namespace opaline::app::viewer {

bool Box::meets(const Box& other) const {
  return x < other.x + other.width && other.x < x + width && y < other.y + other.height &&
         other.y < y + height;
}

Box LabelLayout::within(Box box) const {
  box.x = std::max(bounds_.x, std::min(box.x, bounds_.x + bounds_.width - box.width));
  box.y = std::max(bounds_.y, std::min(box.y, bounds_.y + bounds_.height - box.height));
  return box;
}

Box LabelLayout::place(const Box& wanted) {
  Box box = within(wanted);
  // Every step moves the box above a taken one, so the loop ends.
  for (auto in = taken_.begin(); in != taken_.end();) {
    if (!box.meets(*in)) {
      ++in;
      continue;
    }
    const float above = in->y - box.height;
    if (above < bounds_.y) {
      box = within(wanted);
      break;
    }
    box.y = above;
    in = taken_.begin();
  }
  taken_.push_back(box);
  return box;
}

}  // namespace opaline::app::viewer
