#include "opaline/options/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace opaline {

namespace options {

namespace {

constexpr Range scattering{0, 1e6, "per mm", true};
constexpr Range absorption{0, 1e6, "per mm"};
constexpr Range meanCosine{-0.99, 0.99};
constexpr Range power{0, 1e30};
constexpr Range share{0, 1};
constexpr Range slope{-1000, 1000};
constexpr Range period{1e-3, 1e6, "s"};

}  // namespace

template <>
const std::vector<Field<Medium>>& fieldsOf() {
  static const std::vector<Field<Medium>> table{
      field<Medium, &Medium::sigmaSPrimePerMm>("sigma_s_per_mm", {scattering},
                                               "reduced scattering"),
      field<Medium, &Medium::sigmaAPerMm>("sigma_a_per_mm", {absorption}, "absorption"),
      field<Medium, &Medium::eta>("eta", {{1.01, 3}}, "index of refraction"),
      field<Medium, &Medium::g>("g", {meanCosine}, "mean cosine of scattering"),
  };
  return table;
}

template <>
const std::vector<std::string_view>& namesOf<ColorModel>() {
  static const std::vector<std::string_view> names{"observed", "khr"};
  return names;
}

template <>
const std::vector<Field<Appearance>>& fieldsOf() {
  static const std::vector<Field<Appearance>> table{
      field<Appearance, &Appearance::color>("color", {share},
                                            "share of the light that entered which leaves again"),
      field<Appearance, &Appearance::meanFreePathMm>("mean_free_path_mm", {{1e-6, 1e6, "mm"}},
                                                     "of light in the medium"),
      field<Appearance, &Appearance::g>("g", {meanCosine}, "mean cosine of scattering"),
      field<Appearance, &Appearance::eta>("eta", {{1.01, 1.6}}, "index of refraction"),
      field<Appearance, &Appearance::colorModel>("color_model", {}, "what the color means"),
      field<Appearance, &Appearance::ballMm>("ball_mm", {{0, 1e9, "mm"}},
                                             "diameter of the ball that has the color; 0: no end"),
  };
  return table;
}

template <>
const std::vector<Field<LoadOptions>>& fieldsOf() {
  static const std::vector<Field<LoadOptions>> table{
      field<LoadOptions, &LoadOptions::diagonalMm>("diagonal_mm", {{1e-6, 1e9, "mm"}},
                                                   "of the bounding box"),
      field<LoadOptions, &LoadOptions::colorModel>(
          "color_model", {}, "what colors of media in files mean", "observed"),
  };
  return table;
}

template <>
const std::vector<Field<OpaqueMaterial>>& fieldsOf() {
  static const std::vector<Field<OpaqueMaterial>> table{
      field<OpaqueMaterial, &OpaqueMaterial::baseColor>("base_color", {share},
                                                        "share of light that it gives back"),
      field<OpaqueMaterial, &OpaqueMaterial::metallic>("metallic", {{0, 1}},
                                                       "how much of it is metal"),
      field<OpaqueMaterial, &OpaqueMaterial::roughness>("roughness", {{0, 1}}, "of its reflection"),
      field<OpaqueMaterial, &OpaqueMaterial::specular>("specular", {{0, 1}},
                                                       "strength of the reflection"),
      field<OpaqueMaterial, &OpaqueMaterial::emission>("emission", {power}, "radiance of its own"),
      field<OpaqueMaterial, &OpaqueMaterial::normalScale>("normal_scale", {slope},
                                                          "of its normal texture"),
      field<OpaqueMaterial, &OpaqueMaterial::diffuseTransmission>(
          "diffuse_transmission", {share}, "share of diffuse light that goes through"),
      field<OpaqueMaterial, &OpaqueMaterial::diffuseTransmissionColor>(
          "diffuse_transmission_color", {share}, "of the light that goes through"),
  };
  return table;
}

template <>
const std::vector<Field<TranslucentSurface>>& fieldsOf() {
  static const std::vector<Field<TranslucentSurface>> table{
      field<TranslucentSurface, &TranslucentSurface::roughness>("roughness", {{0, 1}},
                                                                "of its reflection"),
      field<TranslucentSurface, &TranslucentSurface::normalScale>("normal_scale", {slope},
                                                                  "of its normal texture"),
  };
  return table;
}

template <>
const std::vector<Field<Ground>>& fieldsOf() {
  static const std::vector<Field<Ground>> table{
      field<Ground, &Ground::color>("color", {share}, "share of light that it gives back"),
      field<Ground, &Ground::heightMm>("height_mm", {{-1e6, 1e6, "mm"}},
                                       "above the middle of the model"),
  };
  return table;
}

template <>
const std::vector<Field<Camera>>& fieldsOf() {
  static const std::vector<Field<Camera>> table{
      field<Camera, &Camera::verticalFovDegrees>("fov_degrees", {{1, 170, "degrees"}},
                                                 "vertical field of view"),
      field<Camera, &Camera::shiftX>("shift_x", {{-1000, 1000, "widths"}}, "of what is seen"),
      field<Camera, &Camera::shiftY>("shift_y", {{-1000, 1000, "heights"}}, "of what is seen"),
      field<Camera, &Camera::orthographicHeightMm>("orthographic_height_mm", {lengthAboveZero},
                                                   "of what is seen by parallel lines of sight",
                                                   "none"),
  };
  return table;
}

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
      field<RectangleLight, &RectangleLight::radiance>("radiance", {power},
                                                       "the same in all directions"),
      field<RectangleLight, &RectangleLight::twoSided>("two_sided", {}, "light of its back"),
      field<RectangleLight, &RectangleLight::visible>("visible", {}, "seen in the picture itself"),
  };
  return table;
}

template <>
const std::vector<Field<DiscLight>>& fieldsOf() {
  static const std::vector<Field<DiscLight>> table{
      field<DiscLight, &DiscLight::radiusMm>("radius_mm", {lengthAboveZero}, "its radius"),
      field<DiscLight, &DiscLight::radiance>("radiance", {power}, "the same in all directions"),
      field<DiscLight, &DiscLight::twoSided>("two_sided", {}, "light of its back"),
      field<DiscLight, &DiscLight::visible>("visible", {}, "seen in the picture itself"),
  };
  return table;
}

template <>
const std::vector<Field<SphereLight>>& fieldsOf() {
  static const std::vector<Field<SphereLight>> table{
      field<SphereLight, &SphereLight::radiusMm>("radius_mm", {lengthAboveZero}, "its radius"),
      field<SphereLight, &SphereLight::radiance>("radiance", {power}, "the same in all directions"),
      field<SphereLight, &SphereLight::visible>("visible", {}, "seen in the picture itself"),
  };
  return table;
}

template <>
const std::vector<Field<TubeLight>>& fieldsOf() {
  static const std::vector<Field<TubeLight>> table{
      field<TubeLight, &TubeLight::radiusMm>("radius_mm", {lengthAboveZero}, "its radius"),
      field<TubeLight, &TubeLight::radiance>("radiance", {power}, "the same in all directions"),
      field<TubeLight, &TubeLight::visible>("visible", {}, "seen in the picture itself"),
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

template <>
const std::vector<std::string_view>& namesOf<DeformerKind>() {
  static const std::vector<std::string_view> names{"twist", "bend", "squash", "wobble"};
  return names;
}

template <>
const std::vector<Field<Deformer>>& fieldsOf() {
  static const std::vector<Field<Deformer>> table{
      field<Deformer, &Deformer::kind>("kind", {}, "what it does"),
      field<Deformer, &Deformer::amount>("amount", {{-100, 100}}, "an angle or a part of the size"),
      field<Deformer, &Deformer::periodSeconds>("period_seconds", {{0, period.most, "s"}},
                                                "of a swing"),
  };
  return table;
}

Range rangeOfAmount(const Deformer& deformer) {
  switch (deformer.kind) {
    case DeformerKind::Twist:
      return {-100, 100, "radians"};
    case DeformerKind::Bend:
      return {-6.28, 6.28, "radians"};
    case DeformerKind::Squash:
      // A swinging amount takes both signs, and a squash by 1 would leave no height.
      return {deformer.periodSeconds == 0 ? -3 : -0.9, 0.9};
    case DeformerKind::Wobble:
      break;
  }
  return {-1, 1, "diagonals"};
}

std::string complaintAbout(const Deformer& deformer) {
  if (std::string complaint = complaintAboutField(fieldOf<Deformer>("kind"), deformer);
      !complaint.empty())
    return complaint;
  if (deformer.periodSeconds != 0 && !Allowed{period}.holds(deformer.periodSeconds))
    return fmt::format("period_seconds {}: must be 0 or {}", deformer.periodSeconds,
                       describe(period));
  const Range amounts = rangeOfAmount(deformer);
  if (Allowed{amounts}.holds(deformer.amount)) return {};
  const bool swings = deformer.kind == DeformerKind::Squash && deformer.periodSeconds != 0;
  return fmt::format("amount {}: must be {} for a {}{}", deformer.amount, describe(amounts),
                     nameOf(deformer.kind), swings ? " that swings" : "");
}

}  // namespace options

namespace {

constexpr std::size_t mapsOfCube = 6;

bool isFinite(const Vec3& v) {
  return std::all_of(v.begin(), v.end(), [](float x) { return std::isfinite(x); });
}

}  // namespace

std::string complaintAbout(const Medium& medium) {
  return options::complaintAboutFields(medium);
}

std::string complaintAbout(const Appearance& appearance) {
  if (appearance.ballMm > 0 && appearance.colorModel != ColorModel::Observed)
    return "ball_mm is for observed colors, and color_model is another";
  return options::complaintAboutFields(appearance);
}

namespace {

std::string complaintAbout(const Texture& texture) {
  if (!texture.pixels) return "a texture has no pixels";
  constexpr int largestEdge = 16384;
  const auto& [width, height, rgba, name] = *texture.pixels;
  if (width < 1 || height < 1 || width > largestEdge || height > largestEdge)
    return fmt::format("texture '{}' has {}x{} pixels", name, width, height);
  if (rgba.size() !=
      std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    return fmt::format("texture '{}' has {} values for {}x{} pixels", name, rgba.size(), width,
                       height);
  if (texture.coordinates != 0 && texture.coordinates != 1)
    return fmt::format("texture '{}' is on coordinates {}; there are 0 and 1", name,
                       texture.coordinates);
  for (const TextureWrap wrap : {texture.wrapU, texture.wrapV})
    if (!isUpTo(TextureWrap::ClampToEdge, wrap))
      return fmt::format("texture '{}' has an unknown wrap {}", name, static_cast<int>(wrap));
  if (!isFinite(texture.transform[0]) || !isFinite(texture.transform[1]))
    return fmt::format("the transform of texture '{}' is not finite", name);
  return {};
}

bool isWithin(float value, float low, float high) {
  return value >= low && value <= high;
}

}  // namespace

std::string complaintAbout(const OpaqueMaterial& material) {
  if (material.ior != 0 && !isWithin(material.ior, 1, 10))
    return fmt::format("ior {}: must be 0 or from 1 to 10", material.ior);
  for (const float tint : material.specularColor)
    if (!isWithin(tint, 0, 1000)) return "specular_color: must be from 0 to 1000";
  for (const float part : {material.occlusionStrength, material.alphaCutoff, material.alpha})
    if (!isWithin(part, 0, 1))
      return "occlusion strength, alpha and its cutoff: must be from 0 to 1";
  for (const TextureOfMaterial& of : texturesOfMaterial)
    if (const std::optional<Texture>& texture = material.*of.texture; texture)
      if (std::string complaint = complaintAbout(*texture); !complaint.empty()) return complaint;
  return options::complaintAboutFields(material);
}

std::string complaintAbout(const TranslucentSurface& surface) {
  for (const auto member : texturesOfTranslucentSurface)
    if (const std::optional<Texture>& texture = surface.*member; texture)
      if (std::string complaint = complaintAbout(*texture); !complaint.empty()) return complaint;
  return options::complaintAboutFields(surface);
}

std::string complaintAbout(const Paint& paint) {
  for (const float part : paint.color)
    if (!isWithin(part, 0, Paint::mostColor))
      return fmt::format("the colour of its paint: must be from 0 to {}", Paint::mostColor);
  return paint.colorTexture ? complaintAbout(*paint.colorTexture) : std::string{};
}

std::string complaintAbout(const Ground& ground) {
  return options::complaintAboutFields(ground);
}

std::string complaintAbout(const Camera& camera) {
  if (!isFinite(camera.positionMm) || !isFinite(camera.targetMm) || !isFinite(camera.up))
    return "position, target and up must be finite";
  if (camera.positionMm == camera.targetMm) return "position and target must differ";
  return options::complaintAboutFields(camera);
}

std::string complaintAbout(const DirectionalLight& light) {
  if (!isFinite(light.directionToLight) || light.directionToLight == Vec3{})
    return "its direction must be finite and not zero";
  return options::complaintAboutFields(light);
}

std::string complaintAbout(const PointLight& light) {
  if (!isFinite(light.positionMm)) return "its position must be finite";
  return options::complaintAboutFields(light);
}

std::string complaintAbout(const SpotLight& light) {
  if (!isFinite(light.positionMm)) return "its position must be finite";
  if (!isFinite(light.direction) || light.direction == Vec3{})
    return "its direction must be finite and not zero";
  std::string complaint = options::complaintAboutFields(light);
  if (complaint.empty() && light.innerDegrees > light.outerDegrees)
    complaint = fmt::format("inner_degrees {}: must not be above outer_degrees, which is {}",
                            light.innerDegrees, light.outerDegrees);
  return complaint;
}

std::string complaintAbout(const RectangleLight& light) {
  if (!isFinite(light.centreMm) || !isFinite(light.uMm) || !isFinite(light.vMm))
    return "its centre and edges must be finite";
  const auto& [u0, u1, u2] = light.uMm;
  const auto& [v0, v1, v2] = light.vMm;
  const Vec3 area{u1 * v2 - u2 * v1, u2 * v0 - u0 * v2, u0 * v1 - u1 * v0};
  if (!isFinite(area) || area == Vec3{}) return "u_mm and v_mm must neither be zero nor parallel";
  return options::complaintAboutFields(light);
}

std::string complaintAbout(const DiscLight& light) {
  if (!isFinite(light.centreMm)) return "its centre must be finite";
  if (!isFinite(light.normal) || light.normal == Vec3{})
    return "its normal must be finite and not zero";
  return options::complaintAboutFields(light);
}

std::string complaintAbout(const SphereLight& light) {
  if (!isFinite(light.centreMm)) return "its centre must be finite";
  return options::complaintAboutFields(light);
}

std::string complaintAbout(const TubeLight& light) {
  if (!isFinite(light.fromMm) || !isFinite(light.toMm)) return "its ends must be finite";
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

bool isSound(const Image& image) {
  return image.width > 0 && image.height > 0 &&
         image.rgba.size() == std::size_t{4} * static_cast<std::size_t>(image.width) *
                                  static_cast<std::size_t>(image.height);
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
  for (const DirectionalLight& light : lighting.directional)
    if (std::string complaint = complaintAbout(light); !complaint.empty())
      return "a directional light: " + complaint;
  for (const PointLight& light : lighting.points)
    if (std::string complaint = complaintAbout(light); !complaint.empty())
      return "a point light: " + complaint;
  for (const SpotLight& light : lighting.spots)
    if (std::string complaint = complaintAbout(light); !complaint.empty())
      return "a spot light: " + complaint;
  for (const AreaLight& light : lighting.areas)
    if (std::string complaint = complaintAbout(light); !complaint.empty())
      return "an area light: " + complaint;
  std::string complaint = options::complaintAboutFields(lighting);
  return complaint.empty() ? complaint : "the ambient light: " + complaint;
}

}  // namespace opaline
