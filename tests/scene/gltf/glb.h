#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace opaline::test {

/// A binary glTF from a JSON text and a binary chunk.
inline std::string glb(std::string json, std::string binary) {
  const auto word = [](std::size_t value) {
    const auto number = static_cast<std::uint32_t>(value);
    std::string bytes(4, '\0');
    std::memcpy(bytes.data(), &number, 4);
    return bytes;
  };
  while (json.size() % 4 != 0) json += ' ';
  while (binary.size() % 4 != 0) binary += '\0';
  const std::size_t chunk = binary.empty() ? 0 : 8 + binary.size();
  std::string bytes = "glTF" + word(2) + word(20 + json.size() + chunk);
  bytes += word(json.size()) + "JSON" + json;
  if (!binary.empty()) bytes += word(binary.size()) + std::string("BIN\0", 4) + binary;
  return bytes;
}

template <typename T>
std::string raw(const std::vector<T>& values) {
  std::string bytes(values.size() * sizeof(T), '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

}  // namespace opaline::test
