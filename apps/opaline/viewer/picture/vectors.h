#pragma once

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>

#include "opaline/types.h"

namespace opaline::app::viewer {

inline glm::vec3 toGlm(const Vec3& v) {
  return glm::make_vec3(v.data());
}

inline Vec3 fromGlm(const glm::vec3& v) {
  return {v.x, v.y, v.z};
}

}  // namespace opaline::app::viewer
