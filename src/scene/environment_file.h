#pragma once

#include <memory>

#include "opaline/image.h"
#include "options/field.h"
#include "scene/scene_source.h"

namespace opaline::options {

template <>
const std::vector<Field<scene::EnvironmentFile>>& fieldsOf();

}  // namespace opaline::options

namespace opaline::scene {

/// The picture as it lights the scene. Throws Error when it cannot be read or its intensity
/// makes a pixel infinite.
std::shared_ptr<const Image> readEnvironment(const EnvironmentFile& from);

/// A latitude-longitude picture turned about +y, counter-clockwise seen from above: what shone from
/// +z shines from +x after 90 degrees. Row by row it moves left by degrees/360 of its width; where
/// that is no whole number of columns, a pixel is the linear mixture of the two it falls between,
/// so that no light is lost.
Image turned(const Image& environment, double degrees);

}  // namespace opaline::scene
