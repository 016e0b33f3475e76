#include "renderer/frame/light_views.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>

#include "environment/suns.h"

namespace opaline {

static_assert(shared::maxLights == Lighting::maxLights + maxSuns);
static_assert(shared::maxShadowViews == Lighting::maxShadowMaps + maxSuns);

namespace {

constexpr std::uint32_t viewsOfPoint = 6;

}  // namespace

std::uint32_t lightCount(const Lighting& lighting) {
  return static_cast<std::uint32_t>(lighting.directional.size() + lighting.points.size());
}

std::uint32_t shadowViewCount(const Lighting& lighting) {
  return static_cast<std::uint32_t>(lighting.directional.size() +
                                    viewsOfPoint * lighting.points.size());
}

void fillLights(const Lighting& lighting, std::uint32_t shadowSize, shared::FrameData& frame) {
  std::uint32_t light = 0;
  std::uint32_t view = 0;
  for (const DirectionalLight& directional : lighting.directional) {
    shared::LightData& data = frame.lights[light++];
    data.place = {glm::normalize(glm::make_vec3(directional.directionToLight.data())), 0};
    data.power = {glm::make_vec3(directional.irradiance.data()), 0};
    data.kind = {shared::directionalLight, view++, 0, 0};
  }
  for (const PointLight& point : lighting.points) {
    shared::LightData& data = frame.lights[light++];
    data.place = {glm::make_vec3(point.positionMm.data()), 0};
    data.power = {glm::make_vec3(point.intensity.data()), 0};
    data.kind = {shared::pointLight, view, 0, 0};
    view += viewsOfPoint;
  }
  frame.counts.x = light;
  frame.counts.y = shadowSize;
}

}  // namespace opaline
