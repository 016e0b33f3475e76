#pragma once

#include <string>

#include "opaline/scene.h"
#include "options/field.h"

namespace opaline::options {

template <>
const std::vector<Field<Medium>>& fieldsOf();
template <>
const std::vector<Field<Camera>>& fieldsOf();
template <>
const std::vector<Field<DirectionalLight>>& fieldsOf();
template <>
const std::vector<Field<PointLight>>& fieldsOf();

/// Of LoadOptions only the size.
template <>
const std::vector<Field<LoadOptions>>& fieldsOf();

/// Of Lighting only what is not a list: its ambient light.
template <>
const std::vector<Field<Lighting>>& fieldsOf();

}  // namespace opaline::options
