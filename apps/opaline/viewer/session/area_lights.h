#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "opaline/scene.h"

namespace opaline::app::viewer {

// Moving, turning and resizing area lights by hand, for all shapes.

glm::vec3 middleOfArea(const AreaLight& light);
void moveArea(const glm::vec3& middleMm, AreaLight& light);

/// The unit direction along which it shines.
glm::vec3 normalOf(const RectangleLight& light);
/// Turns it to a unit normal, about the vertical and about the level line in it. So it is again
/// what it was when its normal is.
void turnTo(const glm::vec3& normal, RectangleLight& light);

/// The lengths of its edges along u and v, mm.
glm::vec2 edgesMm(const RectangleLight& light);
/// Gives its edges other lengths and keeps their directions.
void setEdges(const glm::vec2& mm, RectangleLight& light);

/// A handle that drags an area light's edge, or turns the light.
struct AreaGrip {
  enum class Kind { U, V, Radius, From, To, Normal };
  Kind kind = Kind::U;
  glm::vec3 placeMm{};
};

/// A rectangle's two edges and its normal, a disc's rim and its normal, a sphere's rim, or a tube's
/// ends. Normals are `reachMm` long. A rim without a direction has its handle in direction
/// `across`.
std::vector<AreaGrip> gripsOf(const AreaLight& light, const glm::vec3& across, float reachMm);

/// Does nothing where the light would have no extent.
void dragGrip(AreaGrip::Kind kind, const glm::vec3& placeMm, AreaLight& light);

/// Its closed outline.
std::vector<glm::vec3> outlineOf(const AreaLight& light, const glm::vec3& ahead);

}  // namespace opaline::app::viewer
