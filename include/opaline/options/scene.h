#pragma once

#include <string>

#include "opaline/export.h"
#include "opaline/motion.h"
#include "opaline/options/field.h"
#include "opaline/scene.h"

namespace opaline::options {

/// What a length may be that must be there.
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

/// The amount's range is the widest; rangeOfAmount() knows that of each kind.
template <>
OPALINE_API const std::vector<Field<Deformer>>& fieldsOf();

/// What a deformer's amount may be. One that swings takes both signs.
OPALINE_API Range rangeOfAmount(const Deformer& deformer);

/// What is wrong with a deformer, as a sentence; empty if nothing.
OPALINE_API std::string complaintAbout(const Deformer& deformer);

/// Of LoadOptions only the size and what colours mean.
template <>
OPALINE_API const std::vector<Field<LoadOptions>>& fieldsOf();

/// Of Lighting only what is not a list: its ambient light.
template <>
OPALINE_API const std::vector<Field<Lighting>>& fieldsOf();

}  // namespace opaline::options
