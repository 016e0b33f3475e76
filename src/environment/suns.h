#pragma once

#include <memory>
#include <vector>

#include "opaline/scene.h"

namespace opaline {

/// The largest number of suns that are taken out of an environment.
constexpr std::size_t maxSuns = 4;

/// An environment's suns, which cast shadows of their own, and the environment without them.
struct Suns {
  std::vector<DirectionalLight> lights;  ///< brightest first
  std::shared_ptr<const Image> rest;     ///< the environment itself if it has no sun and is small
};

/// An environment of more than 2048 columns is scaled down first. A sun is a connected part of the
/// environment, at most 10° wide, that is more than 30 times as bright as the mean and gives more
/// than 1 % of all light. The median radiance around it, up to 25° away, stays in the environment;
/// the light above that becomes the sun's. Throws Error for an environment that cannot be rendered
/// (complaintAboutEnvironment).
Suns findSuns(std::shared_ptr<const Image> environment);

/// Moves the suns of the lighting's environment, as findSuns() returned them, to its directional
/// lights.
void separate(const Suns& suns, Lighting& lighting);

}  // namespace opaline
