#pragma once

#include <optional>
#include <variant>

#include "scene/gltf/file.h"
#include "scene/matrix.h"

namespace opaline::scene {

/// Of KHR_lights_punctual, at a node with that transform: lux become irradiance as they are,
/// candela become intensity in W/sr per unit², where the unit is still a metre here. None of a type
/// that there is not. Throws Error for one that cannot be.
using LightOfFile = std::variant<DirectionalLight, PointLight, SpotLight>;
std::optional<LightOfFile> readLight(const Input& input, const tinygltf::Light& light,
                                     const Matrix4& world, std::size_t node);

/// A camera that looks at what is a metre away. Throws Error for one that sees nothing.
Camera readCamera(const Input& input, const tinygltf::Camera& camera, const Matrix4& world);

/// Whether a node is such that a light or a camera at it has a place and directions.
bool hasDirections(const Matrix4& world);

}  // namespace opaline::scene
