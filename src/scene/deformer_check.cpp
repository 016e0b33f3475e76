#include "scene/deformer_check.h"

#include <fmt/format.h>

#include <cmath>

namespace opaline::scene {

AmountRange amountRange(const Deformer& deformer) {
  switch (deformer.kind) {
    case DeformerKind::Twist:
      return {-100, 100};
    case DeformerKind::Bend:
      return {-6.28, 6.28};
    case DeformerKind::Squash:
      // Swinging it takes both signs, and what is squashed by 1 has no height.
      return {deformer.periodSeconds == 0 ? -3 : -0.9, 0.9};
    case DeformerKind::Wobble:
      return {-1, 1};
  }
  return {};
}

std::string complaintAbout(const Deformer& deformer) {
  constexpr float longest = 1e6F;
  if (!(deformer.periodSeconds >= 0 && deformer.periodSeconds <= longest)) {
    return fmt::format("its period must be in [0, {}] s, not {}", longest, deformer.periodSeconds);
  }
  if (deformer.periodSeconds > 0 && deformer.periodSeconds < 1e-3F) {
    return "its period must be 0 or at least 0.001 s";
  }
  const auto [low, high] = amountRange(deformer);
  if (deformer.amount >= static_cast<float>(low) && deformer.amount <= static_cast<float>(high)) {
    return {};
  }
  const bool swings = deformer.kind == DeformerKind::Squash && deformer.periodSeconds != 0;
  return fmt::format("the amount of a {}{} must be in [{}, {}], not {}",
                     deformerNames[static_cast<std::size_t>(deformer.kind)],
                     swings ? " that swings" : "", low, high, deformer.amount);
}

}  // namespace opaline::scene
