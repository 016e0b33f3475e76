#include "opaline/options/scene.h"

#include <fmt/format.h>

#include "options/allowed.h"

namespace opaline {

namespace options {

namespace {

constexpr Range scattering{0, 1e6, "per mm", true};
constexpr Range absorption{0, 1e6, "per mm"};
constexpr Range meanCosine{-0.99, 0.99};
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
      called("field of view", field<Camera, &Camera::verticalFovDegrees>(
                                  "fov_degrees", {{1, 170, "degrees"}}, "vertical field of view")),
      field<Camera, &Camera::shiftX>("shift_x", {{-1000, 1000, "widths"}}, "of what is seen"),
      field<Camera, &Camera::shiftY>("shift_y", {{-1000, 1000, "heights"}}, "of what is seen"),
      field<Camera, &Camera::orthographicHeightMm>("orthographic_height_mm", {lengthAboveZero},
                                                   "of what is seen by parallel lines of sight",
                                                   "none"),
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

std::string complaintAbout(const Medium& medium) {
  return options::complaintAboutFields(medium);
}

std::string complaintAbout(const Appearance& appearance) {
  if (appearance.ballMm > 0 && appearance.colorModel != ColorModel::Observed)
    return "ball_mm is for observed colors, and color_model is another";
  if (std::string complaint = options::complaintAboutFields(appearance); !complaint.empty())
    return complaint;
  // The color says how much of the extinction is scattering. A texture may have any color.
  for (const double meanFreePathMm : appearance.meanFreePathMm)
    if ((1 - appearance.g) / meanFreePathMm > options::scattering.most)
      return fmt::format("mean_free_path_mm {} and g {}: (1 - g) / mean_free_path_mm must be {}",
                         meanFreePathMm, appearance.g, options::describe(options::scattering));
  return {};
}

namespace {

std::string complaintAbout(const Texture& texture) {
  if (!texture.pixels) return "a texture has no pixels";
  constexpr int largestEdge = 16384;
  const auto& [width, height, rgba, name] = *texture.pixels;
  if (width < 1 || height < 1 || width > largestEdge || height > largestEdge)
    return fmt::format("texture '{}' has {}x{} pixels", name, width, height);
  if (!isSound(*texture.pixels))
    return fmt::format("texture '{}' has {} values for {}x{} pixels", name, rgba.size(), width,
                       height);
  if (texture.coordinates != 0 && texture.coordinates != 1)
    return fmt::format("texture '{}' is on coordinates {}; there are 0 and 1", name,
                       texture.coordinates);
  for (const TextureWrap wrap : {texture.wrapU, texture.wrapV})
    if (!isUpTo(TextureWrap::ClampToEdge, wrap))
      return fmt::format("texture '{}' has an unknown wrap {}", name, static_cast<int>(wrap));
  if (!options::isFinite(texture.transform[0]) || !options::isFinite(texture.transform[1]))
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
  if (!options::isFinite(camera.positionMm) || !options::isFinite(camera.targetMm) ||
      !options::isFinite(camera.up))
    return "position, target and up must be finite";
  if (camera.positionMm == camera.targetMm) return "position and target must differ";
  return options::complaintAboutFields(camera);
}

}  // namespace opaline
