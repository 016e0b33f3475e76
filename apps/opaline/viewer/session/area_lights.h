#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "opaline/scene.h"

namespace opaline::app::viewer {

// Area lights as the window moves, turns and resizes them, all shapes alike.

glm::vec3 middleOfArea(const AreaLight& light);
void moveArea(const glm::vec3& middleMm, AreaLight& light);

/// A place that drags an area light's edge, or turns it.
struct AreaGrip {
  enum class Kind { U, V, Radius, From, To, Normal };
  Kind kind = Kind::U;
  glm::vec3 placeMm{};
};

/// A rectangle's two edges and its normal; a disc's rim and its normal; a sphere's rim; a tube's
/// ends. Normals are `reachMm` long. `across` is where a rim without a direction has its grip.
std::vector<AreaGrip> gripsOf(const AreaLight& light, const glm::vec3& across, float reachMm);

/// Leaves the light as it is where it would have no extent.
void dragGrip(AreaGrip::Kind kind, const glm::vec3& placeMm, AreaLight& light);

/// Its outline, closed.
std::vector<glm::vec3> outlineOf(const AreaLight& light, const glm::vec3& ahead);

}  // namespace opaline::app::viewer
