#pragma once

#include <glm/vec3.hpp>

#include "opaline/scene.h"
#include "viewer/picture/projection.h"
#include "viewer/session/session.h"

namespace opaline::app::viewer {

/// The lights that the window can add. They are behind the scene and to the side, where their
/// handles are in the picture and cover no other, and are as bright as the default ones.
class NewLights {
 public:
  NewLights(const Session& session, const Projection& projection);

  DirectionalLight directional() const;
  PointLight point() const;
  SpotLight spot() const;
  RectangleLight rectangle() const;
  DiscLight disc() const;
  SphereLight sphere() const;
  TubeLight tube() const;

 private:
  Vec3 placeMm() const;
  Rgb intensity() const;

  glm::vec3 targetMm_;
  float diagonalMm_;
  // Unit directions from the target, of three kinds of light.
  glm::vec3 toDirectional_;
  glm::vec3 toPlace_;
  glm::vec3 toTube_;
};

}  // namespace opaline::app::viewer
