#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "scene/gltf/file.h"

namespace opaline::scene {

/// The number that an extension's object holds under a key; none where there is no number.
inline std::optional<double> gltfNumber(const tinygltf::Value& object, const std::string& key) {
  if (!object.Has(key) || !object.Get(key).IsNumber()) return std::nullopt;
  return object.Get(key).GetNumberAsDouble();
}

/// The same for an index or a small whole number. A number that is neither becomes -2, which names
/// nothing.
inline std::optional<int> gltfIndex(const tinygltf::Value& object, const std::string& key) {
  const std::optional<double> number = gltfNumber(object, key);
  if (!number) return std::nullopt;
  constexpr double most = 1e9;
  return *number >= 0 && *number <= most ? static_cast<int>(*number) : -2;
}

template <std::size_t Count>
std::optional<std::array<double, Count>> gltfNumbers(const tinygltf::Value& object,
                                                     const std::string& key) {
  if (!object.Has(key)) return std::nullopt;
  const tinygltf::Value& list = object.Get(key);
  if (!list.IsArray() || list.ArrayLen() != Count) return std::nullopt;
  std::array<double, Count> result{};
  for (std::size_t i = 0; i < Count; ++i) {
    const tinygltf::Value& entry = list.Get<tinygltf::Value::Array>()[i];
    if (!entry.IsNumber()) return std::nullopt;
    result[i] = entry.GetNumberAsDouble();
  }
  return result;
}

/// An extension of a material, or an object without keys.
inline const tinygltf::Value& gltfExtension(const tinygltf::Material& material, const char* name) {
  static const tinygltf::Value none;
  const auto found = material.extensions.find(name);
  return found == material.extensions.end() ? none : found->second;
}

}  // namespace opaline::scene
