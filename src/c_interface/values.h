#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <vector>

#include "opaline/error.h"
#include "opaline/image.h"
#include "opaline/medium.h"
#include "opaline/opaline_c.h"
#include "opaline/scene.h"

namespace opaline::c {

template <typename T>
T& required(T* pointer, const char* name) {
  if (!pointer) throw UsageError(fmt::format("{} is NULL.", name));
  return *pointer;
}

/// The size that a struct had when it came into the interface. One that has grown since gets a
/// specialization here, so that what was compiled before still fits.
template <typename T>
constexpr std::size_t firstSize = sizeof(T);
template <>
inline constexpr std::size_t firstSize<OpalineRendererOptions> = 48;

template <typename T>
void requireSize(const T& structure, const char* name) {
  if (structure.size < firstSize<T> || structure.size > sizeof(T)) {
    throw UsageError(
        fmt::format("{} says that its size is {}; this version knows {} to {} bytes. Set it to "
                    "sizeof first.",
                    name, structure.size, firstSize<T>, sizeof(T)));
  }
}

/// A struct as it was given, and by default where it is shorter.
template <typename T>
T wholeOf(const T* given, const T& standard, const char* name) {
  requireSize(required(given, name), name);
  T whole = standard;
  std::memcpy(&whole, given, given->size);
  return whole;
}

/// Fills a struct as far as the caller knows it.
template <typename T>
void give(T whole, T* to, const char* name) {
  requireSize(required(to, name), name);
  whole.size = to->size;
  std::memcpy(to, &whole, to->size);
}

inline Vec3 vectorOf(const float* values, const char* name) {
  required(values, name);
  return {values[0], values[1], values[2]};
}

Medium mediumOf(const OpalineMedium* given);
void give(const Medium& medium, OpalineMedium* to);

Camera cameraOf(const OpalineCamera* given);
void give(const Camera& camera, OpalineCamera* to);

/// Of 4 · width · height floats.
Image imageOf(const float* rgba, int width, int height, const char* name);

/// Of an array of floats with a stride in bytes; 0: packed.
std::vector<Vec3> positionsOf(const float* positionsMm, std::size_t count, std::size_t strideBytes);

}  // namespace opaline::c

/// What handles of scenes stand for.
struct OpalineScene {
  opaline::Scene scene;
};
