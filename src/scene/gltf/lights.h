#pragma once

#include <optional>
#include <variant>

#include "scene/gltf/file.h"
#include "scene/matrix.h"

namespace opaline::scene {

/// Reads a light of KHR_lights_punctual at a node with that transform. Lux become irradiance
/// unchanged. Candela become intensity in W/sr per unit², the unit here still being a metre. None
/// for an unknown type. Throws Error for an impossible light.
using LightOfFile = std::variant<DirectionalLight, PointLight, SpotLight>;
std::optional<LightOfFile> readLight(const Input& input, const tinygltf::Light& light,
                                     const Matrix4& world, std::size_t node);

/// A camera whose target is a metre away. Throws Error for one that sees nothing.
Camera readCamera(const Input& input, const tinygltf::Camera& camera, const Matrix4& world);

/// Whether a light or a camera at such a node has a position and directions.
bool hasDirections(const Matrix4& world);

}  // namespace opaline::scene
