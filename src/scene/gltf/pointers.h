#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "opaline/motion.h"
#include "scene/gltf/file.h"

namespace opaline::scene {

constexpr const char* pointerExtension = "KHR_animation_pointer";

/// The target of a KHR_animation_pointer that is not a node.
struct GltfPointer {
  enum class Of { Material, Light, Camera };

  Of of = Of::Material;
  std::size_t index = 0;  ///< among the file's
  std::string property;   ///< "pbrMetallicRoughness/roughnessFactor"
  std::size_t width = 1;  ///< how many numbers the property has
};

/// Empty where the channel has none.
std::string pointerOf(const tinygltf::AnimationChannel& channel);

/// None for a property that cannot be animated here, or is not in the file.
std::optional<GltfPointer> readPointer(const tinygltf::Model& model, std::string_view pointer);

/// Sets the property's `width` numbers. A number that a curve has led out of the range of the
/// specification is clamped to it.
void setProperty(const GltfPointer& pointer, std::span<const double> numbers,
                 tinygltf::Material& material);
void setProperty(const GltfPointer& pointer, std::span<const double> numbers,
                 tinygltf::Light& light);
void setProperty(const GltfPointer& pointer, std::span<const double> numbers,
                 tinygltf::Camera& camera);

}  // namespace opaline::scene
