#include "viewer/session/area_lights.h"

#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <variant>

#include "viewer/picture/vectors.h"

namespace opaline::app::viewer {

namespace {

using Kind = AreaGrip::Kind;

struct Axes {
  glm::vec3 u;
  glm::vec3 v;
};

// Two directions orthogonal to a unit direction and to each other.
Axes across(const glm::vec3& normal) {
  const glm::vec3 helper = std::abs(normal.x) < 0.7F ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  const glm::vec3 u = glm::normalize(glm::cross(helper, normal));
  return {u, glm::cross(normal, u)};
}

// Rotates `v` by the rotation that takes one unit direction to another.
glm::vec3 turned(const glm::vec3& v, const glm::vec3& from, const glm::vec3& to) {
  const glm::vec3 axis = glm::cross(from, to);
  const float cosine = glm::dot(from, to);
  if (cosine < -0.9999F) return -v;
  return v + glm::cross(axis, v) + glm::cross(axis, glm::cross(axis, v)) / (1 + cosine);
}

// The axes of a surface with that unit normal that stands upright, with a level lower edge.
glm::mat3 uprightAxes(const glm::vec3& normal) {
  const float turn = std::atan2(normal.x, normal.z);
  const glm::vec3 level(std::cos(turn), 0, -std::sin(turn));
  return {level, glm::cross(normal, level), normal};
}

std::vector<AreaGrip> grips(const RectangleLight& light, const glm::vec3& /*across*/,
                            float reachMm) {
  const glm::vec3 middle = toGlm(light.centreMm);
  return {{Kind::U, middle + toGlm(light.uMm)},
          {Kind::V, middle + toGlm(light.vMm)},
          {Kind::Normal, middle + reachMm * normalOf(light)}};
}

std::vector<AreaGrip> grips(const DiscLight& light, const glm::vec3& /*across*/, float reachMm) {
  const glm::vec3 middle = toGlm(light.centreMm);
  const glm::vec3 normal = glm::normalize(toGlm(light.normal));
  return {{Kind::Radius, middle + light.radiusMm * across(normal).u},
          {Kind::Normal, middle + reachMm * normal}};
}

std::vector<AreaGrip> grips(const SphereLight& light, const glm::vec3& across, float /*reachMm*/) {
  return {{Kind::Radius, toGlm(light.centreMm) + light.radiusMm * across}};
}

std::vector<AreaGrip> grips(const TubeLight& light, const glm::vec3& /*across*/,
                            float /*reachMm*/) {
  return {{Kind::From, toGlm(light.fromMm)}, {Kind::To, toGlm(light.toMm)}};
}

void drag(Kind kind, const glm::vec3& place, RectangleLight& light) {
  const glm::vec3 offset = place - toGlm(light.centreMm);
  if (kind == Kind::U) light.uMm = fromGlm(offset);
  if (kind == Kind::V) light.vMm = fromGlm(offset);
  if (kind != Kind::Normal || !(glm::length(offset) > 0)) return;
  const glm::vec3 before = normalOf(light);
  const glm::vec3 after = glm::normalize(offset);
  light.uMm = fromGlm(turned(toGlm(light.uMm), before, after));
  light.vMm = fromGlm(turned(toGlm(light.vMm), before, after));
}

void drag(Kind kind, const glm::vec3& place, DiscLight& light) {
  const glm::vec3 offset = place - toGlm(light.centreMm);
  if (!(glm::length(offset) > 0)) return;
  if (kind == Kind::Radius) light.radiusMm = glm::length(offset);
  if (kind == Kind::Normal) light.normal = fromGlm(glm::normalize(offset));
}

void drag(Kind /*kind*/, const glm::vec3& place, SphereLight& light) {
  light.radiusMm = glm::length(place - toGlm(light.centreMm));
}

void drag(Kind kind, const glm::vec3& place, TubeLight& light) {
  (kind == Kind::From ? light.fromMm : light.toMm) = fromGlm(place);
}

std::vector<glm::vec3> circle(const glm::vec3& middle, const glm::vec3& normal, float radius) {
  constexpr int sides = 32;
  const Axes axes = across(normal);
  std::vector<glm::vec3> places;
  for (int i = 0; i < sides; ++i) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / sides;
    places.push_back(middle + radius * (std::cos(angle) * axes.u + std::sin(angle) * axes.v));
  }
  return places;
}

std::vector<glm::vec3> outline(const RectangleLight& light, const glm::vec3& /*ahead*/) {
  const glm::vec3 middle = toGlm(light.centreMm);
  const glm::vec3 u = toGlm(light.uMm);
  const glm::vec3 v = toGlm(light.vMm);
  return {middle + u + v, middle - u + v, middle - u - v, middle + u - v};
}

std::vector<glm::vec3> outline(const DiscLight& light, const glm::vec3& /*ahead*/) {
  return circle(toGlm(light.centreMm), glm::normalize(toGlm(light.normal)), light.radiusMm);
}

std::vector<glm::vec3> outline(const SphereLight& light, const glm::vec3& ahead) {
  return circle(toGlm(light.centreMm), ahead, light.radiusMm);
}

std::vector<glm::vec3> outline(const TubeLight& light, const glm::vec3& ahead) {
  const glm::vec3 from = toGlm(light.fromMm);
  const glm::vec3 to = toGlm(light.toMm);
  const glm::vec3 side = glm::cross(to - from, ahead);
  const float length = glm::length(side);
  const glm::vec3 edge = length > 0 ? light.radiusMm / length * side : glm::vec3(0);
  return {from + edge, to + edge, to - edge, from - edge};
}

}  // namespace

glm::vec3 normalOf(const RectangleLight& light) {
  return glm::normalize(glm::cross(toGlm(light.uMm), toGlm(light.vMm)));
}

void turnTo(const glm::vec3& normal, RectangleLight& light) {
  // A rotation's inverse is its transpose.
  const glm::mat3 before = glm::transpose(uprightAxes(normalOf(light)));
  const glm::mat3 after = uprightAxes(normal);
  light.uMm = fromGlm(after * (before * toGlm(light.uMm)));
  light.vMm = fromGlm(after * (before * toGlm(light.vMm)));
}

glm::vec2 edgesMm(const RectangleLight& light) {
  return {2 * glm::length(toGlm(light.uMm)), 2 * glm::length(toGlm(light.vMm))};
}

void setEdges(const glm::vec2& mm, RectangleLight& light) {
  light.uMm = fromGlm(0.5F * mm.x * glm::normalize(toGlm(light.uMm)));
  light.vMm = fromGlm(0.5F * mm.y * glm::normalize(toGlm(light.vMm)));
}

glm::vec3 middleOfArea(const AreaLight& light) {
  if (const auto* tube = std::get_if<TubeLight>(&light))
    return 0.5F * (toGlm(tube->fromMm) + toGlm(tube->toMm));
  return std::visit(
      [](const auto& shape) {
        if constexpr (requires { shape.centreMm; }) return toGlm(shape.centreMm);
        return glm::vec3(0);
      },
      light);
}

void moveArea(const glm::vec3& middleMm, AreaLight& light) {
  if (auto* tube = std::get_if<TubeLight>(&light)) {
    const glm::vec3 by = middleMm - middleOfArea(light);
    tube->fromMm = fromGlm(toGlm(tube->fromMm) + by);
    tube->toMm = fromGlm(toGlm(tube->toMm) + by);
    return;
  }
  std::visit(
      [&](auto& shape) {
        if constexpr (requires { shape.centreMm; }) shape.centreMm = fromGlm(middleMm);
      },
      light);
}

std::vector<AreaGrip> gripsOf(const AreaLight& light, const glm::vec3& across, float reachMm) {
  return std::visit([&](const auto& shape) { return grips(shape, across, reachMm); }, light);
}

void dragGrip(AreaGrip::Kind kind, const glm::vec3& placeMm, AreaLight& light) {
  AreaLight dragged = light;
  std::visit([&](auto& shape) { drag(kind, placeMm, shape); }, dragged);
  if (complaintAbout(dragged).empty()) light = dragged;
}

std::vector<glm::vec3> outlineOf(const AreaLight& light, const glm::vec3& ahead) {
  return std::visit([&](const auto& shape) { return outline(shape, ahead); }, light);
}

}  // namespace opaline::app::viewer
