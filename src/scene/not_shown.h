#pragma once

#include <string_view>
#include <vector>

#include "opaline/log.h"
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

/// What the material of an object has that a medium in its place does not show. AnObject may be
/// raw; its vertices may have colours.
template <typename AnObject>
void addReplaced(std::vector<NotShown>& to, const AnObject& object, bool hasColors) {
  if (object.opaque) addNotShown(to, partsOf(*object.opaque), object.opaque->name);
  if (object.opaque && hasColors) addNotShown(to, "vertex colours", object.name);
  if (object.paint) addNotShown(to, "colour textures of media", object.name);
}

/// Tells of what media in the place of materials do not show, and counts it among the rest.
void noteReplaced(const std::vector<NotShown>& replaced, const LogCallback& log,
                  std::vector<NotShown>& notShown);

/// Adds what another file could not show.
void addNotShown(std::vector<NotShown>& to, const std::vector<NotShown>& more);

}  // namespace opaline::scene
