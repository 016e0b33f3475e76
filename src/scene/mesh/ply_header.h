#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/formats.h"

namespace opaline::scene {

enum class PlyEncoding { Ascii, Little, Big };
enum class PlyScalar { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

std::size_t sizeOf(PlyScalar type);

struct PlyProperty {
  std::string name;
  PlyScalar type = PlyScalar::Float32;
  std::optional<PlyScalar> listCount;
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Ascii;
  std::vector<PlyElement> elements;
  std::size_t bytes = 0;  ///< of the header; the body follows
};

[[noreturn]] void failPly(const Input& input, const std::string& reason);

/// Throws Error where it is no header of a PLY file.
PlyHeader parsePlyHeader(const Input& input);

}  // namespace opaline::scene
