#pragma once

#include <string_view>
#include <vector>

#include "opaline/scene.h"

namespace opaline::scene {

/// Counts one more thing of a kind. Its name may be empty or counted already.
void addNotShown(std::vector<NotShown>& to, std::string_view what, std::string_view name);

/// Parts of a material that a medium does not use.
struct HiddenParts {
  bool baseColor = false;
  bool baseColorTexture = false;
  bool metal = false;
  bool occlusionTexture = false;
  bool emission = false;
  bool alphaMask = false;
};
HiddenParts partsOf(const OpaqueMaterial& material);
void addNotShown(std::vector<NotShown>& to, const HiddenParts& parts, std::string_view name);

/// Adds what another file could not show.
void addNotShown(std::vector<NotShown>& to, const std::vector<NotShown>& more);

}  // namespace opaline::scene
