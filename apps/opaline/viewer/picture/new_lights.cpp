#include "viewer/picture/new_lights.h"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <numbers>
#include <vector>

#include "viewer/picture/light_handles.h"
#include "viewer/picture/vectors.h"
#include "viewer/session/area_lights.h"

namespace opaline::app::viewer {

namespace {

// To the right, up and ahead in the picture, in diagonals of the scene.
constexpr glm::vec3 aside{0.5F, 0.4F, 0.4F};
constexpr glm::vec3 levelAside{0.5F, 0, 0.4F};  // of a tube, which is upright

// Even over the sphere: a spiral of golden angles.
std::vector<glm::vec3> directions() {
  constexpr int count = 512;
  const float golden = std::numbers::pi_v<float> * (3 - std::sqrt(5.0F));
  std::vector<glm::vec3> places;
  for (int i = 0; i < count; ++i) {
    const float y = 1 - (2 * static_cast<float>(i) + 1) / count;
    const float across = std::sqrt(1 - y * y);
    const float turn = golden * static_cast<float>(i);
    places.emplace_back(across * std::sin(turn), y, across * std::cos(turn));
  }
  return places;
}

// By how much two places are nearer to each other than handles that one can tell apart: 0 to 1.
float overlap(const glm::vec2& a, const glm::vec2& b, float apart) {
  return std::max(0.0F, 1 - glm::length(a - b) / apart);
}

// The unit direction from the target to a light at a distance from it: the nearest to the wanted
// one in which the light's handle is in the picture and covers no other, and the light is not below
// the target. What cannot be had is given up from the end of this list.
glm::vec3 directionTo(const Session& session, const Projection& projection, const glm::vec3& wanted,
                      float distanceMm) {
  const float apart = 2 * reachOfHandles();
  const ViewFrame& view = projection.view();
  const glm::vec3 first =
      glm::normalize(wanted.x * view.right + wanted.y * view.up + wanted.z * view.ahead);
  std::vector<glm::vec2> taken;
  for (const glm::vec3& placeMm : placesOfHandles(session, projection))
    if (const auto place = projection.toWindow(placeMm)) taken.push_back(*place);
  const auto drawback = [&](const glm::vec3& direction) {
    const auto place =
        projection.toWindow(toGlm(session.scene.camera.targetMm) + distanceMm * direction);
    if (!place || !projection.area().holds(place->x, place->y, apart)) return 16.0F;
    float covered = 0;
    for (const glm::vec2& other : taken) covered = std::max(covered, overlap(*place, other, apart));
    // Each condition outweighs all that follow; the last term is at most 2.
    return (covered > 0 ? 6 + 4 * covered : 0) + (direction.y < 0 ? 3 : 0) + 1 -
           glm::dot(direction, first);
  };
  glm::vec3 best = first;
  float least = drawback(first);
  for (const glm::vec3& direction : directions()) {
    const float found = drawback(direction);
    if (found >= least) continue;
    least = found;
    best = direction;
  }
  return best;
}

}  // namespace

NewLights::NewLights(const Session& session, const Projection& projection)
    : targetMm_(toGlm(session.scene.camera.targetMm)),
      diagonalMm_(session.diagonalMm),
      toDirectional_(
          directionTo(session, projection, aside, radiusOfSphereMm(session, projection))),
      toPlace_(directionTo(session, projection, aside, glm::length(aside) * diagonalMm_)),
      toTube_(directionTo(session, projection, levelAside, glm::length(levelAside) * diagonalMm_)) {
}

Vec3 NewLights::placeMm() const {
  return fromGlm(targetMm_ + glm::length(aside) * diagonalMm_ * toPlace_);
}

Rgb NewLights::intensity() const {
  const float power = 3 * diagonalMm_ * diagonalMm_;
  return {power, power, power};
}

DirectionalLight NewLights::directional() const {
  return {fromGlm(toDirectional_), {3, 3, 3}};
}

PointLight NewLights::point() const {
  return {placeMm(), intensity()};
}

SpotLight NewLights::spot() const {
  return {placeMm(), fromGlm(-toPlace_), intensity(), 20, 30};
}

RectangleLight NewLights::rectangle() const {
  RectangleLight light{
      placeMm(), {0.26F * diagonalMm_, 0, 0}, {0, 0.28F * diagonalMm_, 0}, {14, 14, 14}};
  turnTo(-toPlace_, light);
  return light;
}

DiscLight NewLights::disc() const {
  return {placeMm(), fromGlm(-toPlace_), 0.28F * diagonalMm_, {14, 14, 14}};
}

SphereLight NewLights::sphere() const {
  return {placeMm(), 0.2F * diagonalMm_, {24, 24, 24}};
}

TubeLight NewLights::tube() const {
  const glm::vec3 middle = targetMm_ + glm::length(levelAside) * diagonalMm_ * toTube_;
  const glm::vec3 half(0, 0.5F * diagonalMm_, 0);
  return {fromGlm(middle - half), fromGlm(middle + half), 0.05F * diagonalMm_, {30, 30, 30}};
}

}  // namespace opaline::app::viewer
