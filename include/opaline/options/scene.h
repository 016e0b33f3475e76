#pragma once

#include <string>

#include "opaline/export.h"
#include "opaline/motion.h"
#include "opaline/options/field.h"
#include "opaline/scene.h"

namespace opaline::options {

/// The range of a length that must not be 0.
constexpr Range lengthAboveZero{0, 1e6, "mm", true};

template <>
OPALINE_API const std::vector<Field<Medium>>& fieldsOf();
template <>
OPALINE_API const std::vector<Field<Camera>>& fieldsOf();
template <>
OPALINE_API const std::vector<Field<OpaqueMaterial>>& fieldsOf();
template <>
OPALINE_API const std::vector<Field<TranslucentSurface>>& fieldsOf();
template <>
OPALINE_API const std::vector<Field<Appearance>>& fieldsOf();
template <>
OPALINE_API const std::vector<Field<Ground>>& fieldsOf();
template <>
OPALINE_API const std::vector<Field<DirectionalLight>>& fieldsOf();
template <>
OPALINE_API const std::vector<Field<PointLight>>& fieldsOf();
template <>
OPALINE_API const std::vector<Field<SpotLight>>& fieldsOf();
template <>
OPALINE_API const std::vector<Field<RectangleLight>>& fieldsOf();
template <>
OPALINE_API const std::vector<Field<DiscLight>>& fieldsOf();
template <>
OPALINE_API const std::vector<Field<SphereLight>>& fieldsOf();
template <>
OPALINE_API const std::vector<Field<TubeLight>>& fieldsOf();

template <>
OPALINE_API const std::vector<std::string_view>& namesOf<DeformerKind>();
template <>
OPALINE_API const std::vector<std::string_view>& namesOf<ColorModel>();

/// The amount has the widest range of all kinds; rangeOfAmount() has that of each.
template <>
OPALINE_API const std::vector<Field<Deformer>>& fieldsOf();

/// The range of a deformer's amount. It is symmetric for a deformer with a period.
OPALINE_API Range rangeOfAmount(const Deformer& deformer);

/// What is wrong with a deformer, as a sentence; empty if nothing.
OPALINE_API std::string complaintAbout(const Deformer& deformer);

/// LoadOptions has only fields for the size and the meaning of colours.
template <>
OPALINE_API const std::vector<Field<LoadOptions>>& fieldsOf();

/// Lighting has only a field for its ambient light, not for its lists.
template <>
OPALINE_API const std::vector<Field<Lighting>>& fieldsOf();

}  // namespace opaline::options
