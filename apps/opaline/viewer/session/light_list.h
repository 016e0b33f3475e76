#pragma once

#include <cstddef>
#include <string>

#include "opaline/scene.h"

namespace opaline::app::viewer {

enum class LightKind { Directional, Point, Spot, Area };

/// Where a light of the window's list stands in the scene.
struct LightEntry {
  LightKind kind = LightKind::Directional;
  std::size_t index = 0;  ///< among those of its kind
};

/// All lights with a handle, one kind after the other.
std::size_t countOf(const Lighting& lighting);

/// Of the list's light of that number, which is below countOf().
LightEntry entryOf(const Lighting& lighting, std::size_t light);

/// Number in the list of the last of its kind, of which there is one.
std::size_t numberOfLast(LightKind kind, const Lighting& lighting);

/// "spot"
std::string nameOf(LightKind kind);
/// "spot 1", "disc 2"
std::string nameOf(const Lighting& lighting, const LightEntry& entry);

/// What the light is coloured by.
Rgb powerOf(const Lighting& lighting, const LightEntry& entry);

void erase(const LightEntry& entry, Lighting& lighting);

}  // namespace opaline::app::viewer
