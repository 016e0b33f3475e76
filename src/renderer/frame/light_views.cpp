#include "renderer/frame/light_views.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>
#include <variant>

#include "environment/suns.h"
#include "lights/area.h"
#include "lights/spot.h"

namespace opaline {

static_assert(shared::maxLights == Lighting::maxLights + maxSuns);
static_assert(shared::maxShadowViews == Lighting::maxShadowMaps + maxSuns);

namespace {

constexpr std::uint32_t viewsOfPoint = 6;

shared::LightData dataOf(const DirectionalLight& light) {
  shared::LightData data{};
  const double radius = glm::radians(double{light.angularRadiusDegrees});
  data.place = {glm::normalize(glm::make_vec3(light.directionToLight.data())), radius * radius / 4};
  data.power = {glm::make_vec3(light.irradiance.data()), 0};
  data.kind = {shared::directionalLight, 0, 1, 0};
  return data;
}

shared::LightData dataOf(const PointLight& light) {
  shared::LightData data{};
  data.place = {glm::make_vec3(light.positionMm.data()), 0};
  data.power = {glm::make_vec3(light.intensity.data()), 0};
  data.cone = {0, 1, 0, 0};
  data.kind = {shared::pointLight, 0, viewsOfPoint, 0};
  return data;
}

shared::LightData dataOf(const SpotLight& light) {
  const SpotFalloff falloff = falloffOf(light);
  shared::LightData data{};
  data.place = {glm::make_vec3(light.positionMm.data()), 0};
  data.power = {glm::make_vec3(light.intensity.data()), 0};
  data.axis = {glm::normalize(glm::make_vec3(light.direction.data())), 0};
  data.cone = {falloff.scale, falloff.offset, std::tan(glm::radians(double{light.outerDegrees})),
               0};
  data.kind = {shared::pointLight, 0, shadowMapsOf(light), 0};
  return data;
}

glm::vec4 packed(const std::array<double, 3>& v, double w = 0) {
  return {v[0], v[1], v[2], w};
}

shared::LightData dataOf(const RectangleLight& light) {
  shared::LightData data{};
  data.axis = {glm::make_vec3(light.uMm.data()), 0};
  data.cone = {glm::make_vec3(light.vMm.data()), 0};
  data.kind.w = shared::rectangleShape;
  return data;
}

shared::LightData dataOf(const DiscLight& light) {
  // The disc's first edge, then the one at right angles to it.
  const glm::dvec3 normal = glm::normalize(glm::dvec3(glm::make_vec3(light.normal.data())));
  const glm::dvec3 helper = std::abs(normal.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 u = double{light.radiusMm} * glm::normalize(glm::cross(helper, normal));
  shared::LightData data{};
  data.axis = {glm::vec3(u), 0};
  data.cone = {glm::vec3(glm::cross(normal, u)), 0};
  data.kind.w = shared::discShape;
  return data;
}

shared::LightData dataOf(const SphereLight& light) {
  shared::LightData data{};
  data.cone.w = light.radiusMm;
  data.kind.w = shared::sphereShape;
  return data;
}

shared::LightData dataOf(const TubeLight& light) {
  shared::LightData data{};
  data.axis = {0.5F * (glm::make_vec3(light.toMm.data()) - glm::make_vec3(light.fromMm.data())), 0};
  data.cone.w = light.radiusMm;
  data.kind.w = shared::tubeShape;
  return data;
}

shared::LightData dataOf(const AreaLight& light) {
  shared::LightData data = std::visit([](const auto& shape) { return dataOf(shape); }, light);
  data.place = packed(middleOf(light));
  data.power = {glm::make_vec3(radianceOf(light).data()), isTwoSided(light) ? 1 : 0};
  data.depth.x = isVisible(light) ? 1 : 0;
  data.kind.x = shared::areaLight;
  return data;
}

}  // namespace

std::uint32_t lightCount(const Lighting& lighting) {
  return static_cast<std::uint32_t>(lighting.directional.size() + lighting.points.size() +
                                    lighting.spots.size() + lighting.areas.size());
}

std::uint32_t shadowViewCount(const Lighting& lighting) {
  std::size_t views = lighting.directional.size() + viewsOfPoint * lighting.points.size();
  for (const SpotLight& light : lighting.spots) views += shadowMapsOf(light);
  return static_cast<std::uint32_t>(views);
}

void fillLights(const Lighting& lighting, std::uint32_t shadowSize, shared::FrameData& frame) {
  std::uint32_t light = 0;
  std::uint32_t view = 0;
  const auto add = [&](shared::LightData data) {
    data.kind.y = view;
    view += data.kind.z;
    frame.lights[light++] = data;
  };
  for (const DirectionalLight& directional : lighting.directional) add(dataOf(directional));
  for (const PointLight& point : lighting.points) add(dataOf(point));
  for (const SpotLight& spot : lighting.spots) add(dataOf(spot));
  frame.counts.x = light;
  frame.counts.y = shadowSize;
  for (const AreaLight& area : lighting.areas) frame.lights[light++] = dataOf(area);
  frame.counts.w = light;
}

}  // namespace opaline
