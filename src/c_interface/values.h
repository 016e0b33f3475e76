#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "c_interface/living.h"
#include "opaline/error.h"
#include "opaline/image.h"
#include "opaline/log.h"
#include "opaline/medium.h"
#include "opaline/opaline_c.h"
#include "opaline/options/scene.h"
#include "opaline/scene.h"

namespace opaline::c {

/// What a pointer points to. Throws UsageError for null and for a handle that is not living.
template <typename T>
T& required(T* pointer, const char* name) {
  if (!pointer) throw UsageError(fmt::format("{} is NULL.", name));
  constexpr const char* kind = kindOf<std::remove_const_t<T>>;
  if constexpr (kind != nullptr) {
    if (!isLiving(pointer))
      throw UsageError(fmt::format(
          "{} is no {} that was made and is still there; it may have been destroyed.", name, kind));
  }
  return *pointer;
}

/// The size of a struct when it was added to the interface. A struct that has grown since has a
/// specialization, so that programs compiled before still work.
template <typename T>
constexpr std::size_t firstSize = sizeof(T);
template <>
inline constexpr std::size_t firstSize<OpalineRendererOptions> = 48;
template <>
inline constexpr std::size_t firstSize<OpalineRenderOptions> = 72;
template <>
inline constexpr std::size_t firstSize<OpalineLoadOptions> = 24;
template <>
inline constexpr std::size_t firstSize<OpalineCamera> = 48;

template <typename T>
void requireSize(const T& structure, const char* name) {
  if (structure.size < firstSize<T> || structure.size > sizeof(T)) {
    throw UsageError(
        fmt::format("{} says that its size is {}; this version knows {} to {} bytes. Set it to "
                    "sizeof first.",
                    name, structure.size, firstSize<T>, sizeof(T)));
  }
}

/// A struct as it was given, with defaults for members that a shorter one lacks.
template <typename T>
T wholeOf(const T* given, const T& standard, const char* name) {
  requireSize(required(given, name), name);
  T whole = standard;
  std::memcpy(&whole, given, given->size);
  return whole;
}

/// Fills the members of a struct that the caller's version has.
template <typename T>
void give(T whole, T* to, const char* name) {
  requireSize(required(to, name), name);
  whole.size = to->size;
  std::memcpy(to, &whole, to->size);
}

/// A value of an enumeration whose values go from 0 to `last`. C programs may pass any number.
/// Others are not values of the type in C++ and must not be read as such.
template <typename Choice, typename Given>
Choice choiceOf(const Given& given, Given last, const char* name) {
  std::int32_t number = 0;
  static_assert(sizeof number == sizeof given);
  std::memcpy(&number, &given, sizeof number);
  if (number < 0 || number > static_cast<std::int32_t>(last)) {
    throw UsageError(fmt::format("There is no {} {}.", name, number));
  }
  return static_cast<Choice>(number);
}

/// Returns a value that can be rendered; throws UsageError for any other.
template <typename T>
T sound(T value) {
  using options::complaintAbout;
  const std::string complaint = complaintAbout(value);
  if (!complaint.empty()) throw UsageError(complaint);
  return value;
}

inline Vec3 vectorOf(const float* values, const char* name) {
  required(values, name);
  return {values[0], values[1], values[2]};
}

Medium mediumOf(const OpalineMedium* given);
void give(const Medium& medium, OpalineMedium* to);

ColorModel colorModelOf(const OpalineColorModel& given);

Camera cameraOf(const OpalineCamera* given);
void give(const Camera& camera, OpalineCamera* to);

void requirePictureSize(int width, int height);

/// The image of 4 · width · height floats.
Image imageOf(const float* rgba, int width, int height, const char* name);

LogCallback logOf(OpalineLog log, void* context);

/// The strings of an array, as they are given in C.
std::vector<std::string> stringsOf(const char* const* strings, std::size_t count, const char* name);

/// Copies as much of a text as there is room for.
void give(std::string_view text, char* to, std::size_t roomBytes, const char* name);

LoadOptions loadOptionsOf(const OpalineLoadOptions* given);

/// Throws UsageError for an array with more elements than `most`, before any of it is read.
void requireCount(std::size_t count, std::size_t most, const char* name);

/// Calls `use` for each struct of an array. The first one's size is the distance between them,
/// which may differ from this version's.
template <typename T, typename Use>
void forEachOf(const T* first, std::size_t count, std::size_t most, const char* name,
               const Use& use) {
  requireCount(count, most, name);
  if (count == 0) return;
  requireSize(required(first, name), name);
  const std::size_t bytes = first->size;
  const auto* at = reinterpret_cast<const char*>(first);
  for (std::size_t i = 0; i < count; ++i, at += bytes) {
    const auto* structure = reinterpret_cast<const T*>(at);
    if (structure->size != bytes)
      throw UsageError(
          fmt::format("{} has structs of {} and of {} bytes.", name, bytes, structure->size));
    use(wholeOf(structure, {}, name));
  }
}

/// More than any mesh has. A larger count is a mistake, which is noticed before the array is read.
constexpr std::size_t mostVectors = INT32_MAX;

/// Vectors of an array of floats with a stride in bytes; 0: packed.
template <typename Vector>
std::vector<Vector> vectorsOf(const float* values, std::size_t count, std::size_t strideBytes,
                              const char* name) {
  requireCount(count, mostVectors, name);
  if (count > 0) required(values, name);
  if (strideBytes == 0) strideBytes = sizeof(Vector);
  if (strideBytes < sizeof(Vector)) {
    throw UsageError(fmt::format("{}: a stride of {} bytes is less than the {} of one vertex.",
                                 name, strideBytes, sizeof(Vector)));
  }
  std::vector<Vector> vectors(count);
  const auto* from = reinterpret_cast<const char*>(values);
  for (std::size_t i = 0; i < count; ++i) {
    std::memcpy(vectors[i].data(), from + i * strideBytes, sizeof(Vector));
  }
  return vectors;
}

/// Writes the values of `count` vertices or triangles one after the other.
template <typename Vector>
void give(const std::vector<Vector>& vectors, typename Vector::value_type* to, std::size_t count,
          const char* name) {
  if (count != vectors.size()) {
    throw UsageError(
        fmt::format("{} has room for {}, but there are {}.", name, count, vectors.size()));
  }
  if (count > 0) required(to, name);
  for (const Vector& vector : vectors) to = std::copy(vector.begin(), vector.end(), to);
}

}  // namespace opaline::c

/// What a handle of a scene points to.
struct OpalineScene : opaline::c::Handle<OpalineScene> {
  opaline::Scene scene;
};

namespace opaline::c {

/// Element `index` of a list. `has` begins the message about how many there are.
template <typename List>
auto& oneOf(List& list, std::size_t index, const char* name, const char* has = "the scene has") {
  if (index >= list.size())
    throw UsageError(fmt::format("There is no {} {}: {} {}.", name, index, has, list.size()));
  return list[index];
}

template <typename AScene>
auto& objectOf(AScene* scene, std::size_t index) {
  return oneOf(required(scene, "scene").scene.objects, index, "object");
}

/// Gives the caller the handle of a scene, which the caller will destroy.
void giveScene(Scene scene, OpalineScene** to);

}  // namespace opaline::c
