#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <variant>

#include "opaline/options/scene.h"
#include "options/allowed.h"

namespace opaline {

namespace options {

namespace {

// What shapes of area lights have in common.
template <typename Shape>
Field<Shape> radiusOf() {
  return field<Shape, &Shape::radiusMm>("radius_mm", {lengthAboveZero}, "its radius");
}
template <typename Shape>
Field<Shape> radianceOf() {
  return field<Shape, &Shape::radiance>("radiance", {power}, "the same in all directions");
}
template <typename Shape>
Field<Shape> twoSidedOf() {
  return field<Shape, &Shape::twoSided>("two_sided", {}, "light of its back");
}
template <typename Shape>
Field<Shape> visibleOf() {
  return field<Shape, &Shape::visible>("visible", {}, "seen in the picture itself");
}

}  // namespace

template <>
const std::vector<Field<DirectionalLight>>& fieldsOf() {
  static const std::vector<Field<DirectionalLight>> table{
      field<DirectionalLight, &DirectionalLight::irradiance>("irradiance", {power},
                                                             "on a surface that faces it"),
      field<DirectionalLight, &DirectionalLight::angularRadiusDegrees>(
          "angular_radius_degrees", {{0, 10, "degrees"}}, "of the disc that surfaces mirror"),
  };
  return table;
}

template <>
const std::vector<Field<PointLight>>& fieldsOf() {
  static const std::vector<Field<PointLight>> table{
      field<PointLight, &PointLight::intensity>("intensity", {power}, "irradiance at 1 mm"),
  };
  return table;
}

template <>
const std::vector<Field<SpotLight>>& fieldsOf() {
  static const std::vector<Field<SpotLight>> table{
      field<SpotLight, &SpotLight::intensity>("intensity", {power},
                                              "irradiance at 1 mm, on its axis"),
      field<SpotLight, &SpotLight::innerDegrees>("inner_degrees", {{0, 90, "degrees"}},
                                                 "from its axis, where it begins to fall off"),
      field<SpotLight, &SpotLight::outerDegrees>("outer_degrees", {{0, 90, "degrees", true}},
                                                 "from its axis, where it ends"),
  };
  return table;
}

template <>
const std::vector<Field<RectangleLight>>& fieldsOf() {
  static const std::vector<Field<RectangleLight>> table{
      radianceOf<RectangleLight>(),
      twoSidedOf<RectangleLight>(),
      visibleOf<RectangleLight>(),
  };
  return table;
}

template <>
const std::vector<Field<DiscLight>>& fieldsOf() {
  static const std::vector<Field<DiscLight>> table{
      radiusOf<DiscLight>(),
      radianceOf<DiscLight>(),
      twoSidedOf<DiscLight>(),
      visibleOf<DiscLight>(),
  };
  return table;
}

template <>
const std::vector<Field<SphereLight>>& fieldsOf() {
  static const std::vector<Field<SphereLight>> table{
      radiusOf<SphereLight>(),
      radianceOf<SphereLight>(),
      visibleOf<SphereLight>(),
  };
  return table;
}

template <>
const std::vector<Field<TubeLight>>& fieldsOf() {
  static const std::vector<Field<TubeLight>> table{
      radiusOf<TubeLight>(),
      radianceOf<TubeLight>(),
      visibleOf<TubeLight>(),
  };
  return table;
}

template <>
const std::vector<Field<Lighting>>& fieldsOf() {
  static const std::vector<Field<Lighting>> table{
      field<Lighting, &Lighting::ambient>("radiance", {power}, "radiance from everywhere"),
  };
  return table;
}

}  // namespace options

namespace {

constexpr std::size_t mapsOfCube = 6;

}  // namespace

std::string complaintAbout(const DirectionalLight& light) {
  if (!options::isFinite(light.directionToLight) || light.directionToLight == Vec3{})
    return "its direction must be finite and not zero";
  return options::complaintAboutFields(light);
}

std::string complaintAbout(const PointLight& light) {
  if (!options::isFinite(light.positionMm)) return "its position must be finite";
  return options::complaintAboutFields(light);
}

std::string complaintAbout(const SpotLight& light) {
  if (!options::isFinite(light.positionMm)) return "its position must be finite";
  if (!options::isFinite(light.direction) || light.direction == Vec3{})
    return "its direction must be finite and not zero";
  std::string complaint = options::complaintAboutFields(light);
  if (complaint.empty() && light.innerDegrees > light.outerDegrees)
    complaint = fmt::format("inner_degrees {}: must not be above outer_degrees, which is {}",
                            light.innerDegrees, light.outerDegrees);
  return complaint;
}

std::string complaintAbout(const RectangleLight& light) {
  if (!options::isFinite(light.centreMm) || !options::isFinite(light.uMm) ||
      !options::isFinite(light.vMm))
    return "its centre and edges must be finite";
  const auto& [u0, u1, u2] = light.uMm;
  const auto& [v0, v1, v2] = light.vMm;
  const Vec3 area{u1 * v2 - u2 * v1, u2 * v0 - u0 * v2, u0 * v1 - u1 * v0};
  if (!options::isFinite(area) || area == Vec3{})
    return "u_mm and v_mm must neither be zero nor parallel";
  return options::complaintAboutFields(light);
}

std::string complaintAbout(const DiscLight& light) {
  if (!options::isFinite(light.centreMm)) return "its centre must be finite";
  if (!options::isFinite(light.normal) || light.normal == Vec3{})
    return "its normal must be finite and not zero";
  return options::complaintAboutFields(light);
}

std::string complaintAbout(const SphereLight& light) {
  if (!options::isFinite(light.centreMm)) return "its centre must be finite";
  return options::complaintAboutFields(light);
}

std::string complaintAbout(const TubeLight& light) {
  if (!options::isFinite(light.fromMm) || !options::isFinite(light.toMm))
    return "its ends must be finite";
  if (light.fromMm == light.toMm) return "its ends must be two places";
  return options::complaintAboutFields(light);
}

std::string complaintAbout(const AreaLight& light) {
  return std::visit([](const auto& shape) { return complaintAbout(shape); }, light);
}

std::size_t shadowMapsOf(const SpotLight& light) {
  constexpr float widestView = 50;  // degrees; the rim of wider ones would get few texels
  return light.outerDegrees <= widestView ? 1 : mapsOfCube;
}

namespace {

template <typename Light>
std::string complaintAboutAny(std::string_view kind, const std::vector<Light>& lights) {
  for (const Light& light : lights)
    if (const std::string complaint = complaintAbout(light); !complaint.empty())
      return fmt::format("{}: {}", kind, complaint);
  return {};
}

}  // namespace

std::string complaintAboutEnvironment(const Image& environment) {
  if (!isSound(environment))
    return fmt::format(
        "the environment has {}x{} pixels and {} values, but needs four for each pixel",
        environment.width, environment.height, environment.rgba.size());
  for (std::size_t i = 0; i < environment.rgba.size(); ++i)
    if (i % 4 != 3 && !(environment.rgba[i] >= 0 && std::isfinite(environment.rgba[i])))
      return fmt::format("pixel {} of the environment is negative or not finite", i / 4);
  return "";
}

std::string complaintAbout(const Lighting& lighting) {
  if (lighting.environment && !isSound(*lighting.environment))
    return complaintAboutEnvironment(*lighting.environment);
  const std::size_t directional = lighting.directional.size();
  const std::size_t points = lighting.points.size();
  const std::size_t spots = lighting.spots.size();
  std::size_t maps = directional + mapsOfCube * points;
  for (const SpotLight& light : lighting.spots) maps += shadowMapsOf(light);
  const std::size_t areas = lighting.areas.size();
  if (const std::size_t all = directional + points + spots + areas; all > Lighting::maxLights)
    return fmt::format(
        "there are {} lights, {} directional, {} point, {} spot and {} area lights, but there may "
        "be {} lights in all",
        all, directional, points, spots, areas, Lighting::maxLights);
  if (maps > Lighting::maxShadowMaps)
    return fmt::format(
        "{} directional, {} point and {} spot lights need {} shadow maps, but there may be {}: 1 "
        "for a directional light, 6 for a point light and 1 for a spot light, or 6 where its outer "
        "angle is above 50 degrees",
        directional, points, spots, maps, Lighting::maxShadowMaps);
  for (const std::string& complaint :
       {complaintAboutAny("a directional light", lighting.directional),
        complaintAboutAny("a point light", lighting.points),
        complaintAboutAny("a spot light", lighting.spots),
        complaintAboutAny("an area light", lighting.areas)})
    if (!complaint.empty()) return complaint;
  std::string complaint = options::complaintAboutFields(lighting);
  return complaint.empty() ? complaint : "the ambient light: " + complaint;
}

}  // namespace opaline
