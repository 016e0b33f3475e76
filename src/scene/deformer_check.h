#pragma once

#include <array>
#include <string>
#include <string_view>

#include "opaline/motion.h"

namespace opaline::scene {

/// In the order of DeformerKind, as files and the command line spell them.
constexpr std::array<std::string_view, 4> deformerNames{"twist", "bend", "squash", "wobble"};

/// What a deformer's amount may be, ends included. One that swings takes both signs.
struct AmountRange {
  double least = 0;
  double most = 0;
};
AmountRange amountRange(const Deformer& deformer);

/// What is wrong with a deformer, empty if nothing: the ranges of opaline/motion.h.
std::string complaintAbout(const Deformer& deformer);

}  // namespace opaline::scene
