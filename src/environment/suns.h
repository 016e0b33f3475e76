#pragma once

#include <memory>
#include <vector>

#include "opaline/scene.h"

namespace opaline {

/// Most suns of an environment.
constexpr std::size_t maxSuns = 4;

/// An environment's suns, which cast shadows of their own, and what is left of it without them.
struct Suns {
  std::vector<DirectionalLight> lights;  ///< brightest first
  std::shared_ptr<const Image> rest;  ///< the environment itself where it has no sun and is small
};

/// Of an environment of more than 2048 columns a smaller copy is taken. A sun is a connected part
/// of the environment, at most 10° wide, that is more than 30 times as bright as the mean and gives
/// more than 1 % of all light. It stands before what is seen around it, up to 25° away: the median
/// there stays in the environment, and the light above it becomes the sun's.
Suns findSuns(std::shared_ptr<const Image> environment);

/// Puts the suns of a light's environment, which these are, among its directional lights.
void separate(const Suns& suns, Lighting& lighting);

}  // namespace opaline
