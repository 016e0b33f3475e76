#pragma once

#include <string>

#include "opaline/motion.h"
#include "opaline/scene.h"
#include "options/field.h"

namespace opaline::options {

/// What a length may be that must be there.
constexpr Range lengthAboveZero{0, 1e6, "mm", true};

template <>
const std::vector<Field<Medium>>& fieldsOf();
template <>
const std::vector<Field<Camera>>& fieldsOf();
template <>
const std::vector<Field<OpaqueMaterial>>& fieldsOf();
template <>
const std::vector<Field<Appearance>>& fieldsOf();
template <>
const std::vector<Field<Ground>>& fieldsOf();
template <>
const std::vector<Field<DirectionalLight>>& fieldsOf();
template <>
const std::vector<Field<PointLight>>& fieldsOf();
template <>
const std::vector<Field<SpotLight>>& fieldsOf();
template <>
const std::vector<Field<RectangleLight>>& fieldsOf();
template <>
const std::vector<Field<DiscLight>>& fieldsOf();
template <>
const std::vector<Field<SphereLight>>& fieldsOf();
template <>
const std::vector<Field<TubeLight>>& fieldsOf();

template <>
const std::vector<std::string_view>& namesOf<DeformerKind>();

/// The amount's range is the widest; rangeOfAmount() knows that of each kind.
template <>
const std::vector<Field<Deformer>>& fieldsOf();

/// What a deformer's amount may be. One that swings takes both signs.
Range rangeOfAmount(const Deformer& deformer);

/// What is wrong with a deformer, as a sentence; empty if nothing.
std::string complaintAbout(const Deformer& deformer);

/// Of LoadOptions only the size.
template <>
const std::vector<Field<LoadOptions>>& fieldsOf();

/// Of Lighting only what is not a list: its ambient light.
template <>
const std::vector<Field<Lighting>>& fieldsOf();

}  // namespace opaline::options
