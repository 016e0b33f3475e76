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

/// What KHR_animation_pointer points to, beside nodes.
struct GltfPointer {
  enum class Of { Material, Light, Camera };

  Of of = Of::Material;
  std::size_t index = 0;  ///< among the file's
  std::string property;   ///< "pbrMetallicRoughness/roughnessFactor"
  std::size_t width = 1;  ///< numbers that it has
};

/// Empty where the channel has none.
std::string pointerOf(const tinygltf::AnimationChannel& channel);

/// None for what cannot be animated here, or is not in the file.
std::optional<GltfPointer> readPointer(const tinygltf::Model& model, std::string_view pointer);

/// Sets the property, `width` numbers of it. Those that a curve has led out of the range that the
/// specification allows are set to its ends.
void setProperty(const GltfPointer& pointer, std::span<const double> numbers,
                 tinygltf::Material& material);
void setProperty(const GltfPointer& pointer, std::span<const double> numbers,
                 tinygltf::Light& light);
void setProperty(const GltfPointer& pointer, std::span<const double> numbers,
                 tinygltf::Camera& camera);

}  // namespace opaline::scene
