#include "renderer/light_views.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>

namespace opaline {

namespace {

// Texels that percentage-closer filtering reaches beyond the receiver's own.
constexpr float filterBorder = 3;

struct Basis {
  glm::vec3 right, up, forward;
};

Basis basisAlong(const glm::vec3& forward) {
  const glm::vec3 helper = std::abs(forward.y) < 0.9F ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 right = glm::normalize(glm::cross(forward, helper));
  return {right, glm::cross(right, forward), forward};
}

struct Interval {
  float low = std::numeric_limits<float>::max();
  float high = std::numeric_limits<float>::lowest();

  float length() const { return high - low; }
  void widen(float by) {
    low -= by;
    high += by;
  }
};

Interval project(const Bounds& bounds, const glm::vec3& axis) {
  Interval interval;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const glm::vec3 point((corner & 1U) != 0 ? bounds.maxMm[0] : bounds.minMm[0],
                          (corner & 2U) != 0 ? bounds.maxMm[1] : bounds.minMm[1],
                          (corner & 4U) != 0 ? bounds.maxMm[2] : bounds.minMm[2]);
    const float along = glm::dot(axis, point);
    interval.low = std::min(interval.low, along);
    interval.high = std::max(interval.high, along);
  }
  return interval;
}

glm::mat4 fromRows(const glm::vec4& x, const glm::vec4& y, const glm::vec4& z, const glm::vec4& w) {
  return glm::transpose(glm::mat4(x, y, z, w));
}

// Maps the interval to [-1, 1].
glm::vec4 fittedRow(const glm::vec3& axis, const Interval& interval) {
  return {axis * (2 / interval.length()), -(interval.low + interval.high) / interval.length()};
}

void addDirectional(const DirectionalLight& light, const Bounds& bounds, float shadowSize,
                    shared::LightData& data, glm::mat4& view) {
  const glm::vec3 toLight = glm::normalize(glm::make_vec3(light.directionToLight.data()));
  const Basis basis = basisAlong(-toLight);
  Interval x = project(bounds, basis.right);
  Interval y = project(bounds, basis.up);
  Interval z = project(bounds, basis.forward);
  const float slack = 1e-3F * std::max({x.length(), y.length(), z.length(), 1e-6F});
  x.widen(slack + x.length() * filterBorder / shadowSize);
  y.widen(slack + y.length() * filterBorder / shadowSize);
  z.widen(slack);

  const glm::vec4 depth(-basis.forward / z.length(), z.high / z.length());
  view = fromRows(fittedRow(basis.right, x), fittedRow(basis.up, y), depth, {0, 0, 0, 1});
  data.place = {toLight, 0};
  data.power = {glm::make_vec3(light.irradiance.data()), 0};
  data.depth = {z.high, -z.length(), 0, 0};
  data.texel.x = std::max(x.length(), y.length()) / shadowSize;
}

float nearPlaneMm(const glm::vec3& position, const Bounds& bounds) {
  const glm::vec3 low = glm::make_vec3(bounds.minMm.data());
  const glm::vec3 high = glm::make_vec3(bounds.maxMm.data());
  const float distance = glm::length(position - glm::clamp(position, low, high));
  // A face's depth is at least 1/√3 of the distance.
  return std::max({0.5F * distance, 1e-3F * glm::length(high - low), 1e-6F});
}

void addPoint(const PointLight& light, const Bounds& bounds, float shadowSize,
              shared::LightData& data, glm::mat4* views) {
  const glm::vec3 position = glm::make_vec3(light.positionMm.data());
  const float nearMm = nearPlaneMm(position, bounds);
  const float tangent = 1 + 2 * filterBorder / shadowSize;
  static const std::array<glm::vec3, 6> axes{
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
  for (std::size_t face = 0; face < 6; ++face) {
    const Basis basis = basisAlong(axes[face]);
    const auto row = [&](const glm::vec3& v) { return glm::vec4(v, -glm::dot(v, position)); };
    views[face] = fromRows(row(basis.right) / tangent, row(basis.up) / tangent, {0, 0, 0, nearMm},
                           row(basis.forward));
  }
  data.place = {position, 1};
  data.power = {glm::make_vec3(light.intensity.data()), 0};
  data.depth = {nearMm, 0, 0, 0};
  data.texel.x = 2 * tangent / shadowSize;
}

}  // namespace

std::uint32_t shadowViewCount(const Lighting& lighting) {
  return static_cast<std::uint32_t>(lighting.directional.size() + 6 * lighting.points.size());
}

void fillLights(const Lighting& lighting, const Bounds& bounds, std::uint32_t shadowSize,
                shared::FrameData& frame) {
  std::uint32_t light = 0;
  std::uint32_t view = 0;
  const auto size = static_cast<float>(shadowSize);
  for (const DirectionalLight& directional : lighting.directional) {
    frame.lights[light].views = {view, 1, 0, 0};
    addDirectional(directional, bounds, size, frame.lights[light], frame.shadowViews[view]);
    ++light;
    ++view;
  }
  for (const PointLight& point : lighting.points) {
    frame.lights[light].views = {view, 6, 0, 0};
    addPoint(point, bounds, size, frame.lights[light], &frame.shadowViews[view]);
    ++light;
    view += 6;
  }
  frame.counts.x = light;
  frame.counts.y = shadowSize;
}

}  // namespace opaline
