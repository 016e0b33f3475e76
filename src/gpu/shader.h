#pragma once

#include <cstdint>
#include <span>
#include <type_traits>

namespace opaline::gpu {

/// A TexelBuffer is read four floats at a time by texelFetch (samplerBuffer), which software
/// devices do faster than reading storage buffers.
enum class BindingType {
  UniformBuffer,
  StorageBuffer,
  TexelBuffer,
  SampledImage,
  StorageImage,
  AccelerationStructure
};

/// `binding` of set 0, below 32, visible to every stage.
struct BindingSlot {
  std::uint32_t binding = 0;
  BindingType type = BindingType::StorageBuffer;
};

/// How shaders read tables of four floats (lib/texels.glsl), and whether they use the device's ray
/// queries. A shader without a variant uses the one before it.
enum class ShaderVariant { Texels, Storage, RayQueries };

/// A compiled shader and its interface. cmake/shader_interface.py makes a struct for each shader,
/// with its Push, Bindings and Constants besides its shader().
struct Shader {
  std::span<const std::uint32_t> words;
  std::span<const BindingSlot> slots;
  std::uint32_t pushConstantBytes = 0;  ///< at most 128
};

/// A member that cannot be left out of an initializer. Enumerators convert to their numbers.
template <typename T>
struct Required {
  // NOLINTBEGIN(google-explicit-constructor)
  constexpr Required(const T& given) : value(given) {}
  template <typename E>
  requires std::is_enum_v<E>
  constexpr Required(E given) : value(static_cast<T>(given)) {}
  // NOLINTEND(google-explicit-constructor)
  T value;
};

}  // namespace opaline::gpu
