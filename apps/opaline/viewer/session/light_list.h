#pragma once

#include <cstddef>
#include <string>

#include "opaline/scene.h"

namespace opaline::app::viewer {

enum class LightKind { Directional, Point, Spot, Area };

/// Which light of the scene an entry of the window's list is.
struct LightEntry {
  LightKind kind = LightKind::Directional;
  std::size_t index = 0;  ///< among those of its kind
};

/// How many lights have handles. The list has one kind after the other.
std::size_t countOf(const Lighting& lighting);

/// The entry with that number, which must be below countOf().
LightEntry entryOf(const Lighting& lighting, std::size_t light);

/// The number of the last light of a kind, of which there must be one.
std::size_t numberOfLast(LightKind kind, const Lighting& lighting);

/// A name such as "spot".
std::string nameOf(LightKind kind);
/// A name such as "spot 1" or "disc 2", the second disc of the list.
std::string nameOf(const Lighting& lighting, const LightEntry& entry);

/// The value that gives the light its colour.
Rgb powerOf(const Lighting& lighting, const LightEntry& entry);

void erase(const LightEntry& entry, Lighting& lighting);

}  // namespace opaline::app::viewer
