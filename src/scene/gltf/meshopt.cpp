#include "scene/gltf/meshopt.h"

#include <fmt/format.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include "scene/gltf/meshopt_attributes.h"
#include "scene/text.h"

namespace opaline::scene {

namespace {

/// How a view is compressed, in the terms of the extension.
struct Compression {
  std::string view;  ///< how messages call it
  std::span<const unsigned char> bytes;
  std::size_t count = 0;
  std::size_t stride = 0;
  std::string mode;
  std::string filter;
};

/// A mode, and the most bytes that it can make of one.
struct Mode {
  const char* name;
  std::size_t mostOfOneByte;
};
constexpr std::array<Mode, 3> modes{{
    {"ATTRIBUTES", 1024},  // two bits for one byte of each of 256 elements
    {"TRIANGLES", 12},
    {"INDICES", 4},
}};

/// Two's complement.
template <typename T>
int signedValue(T bits) {
  constexpr int most = std::numeric_limits<T>::max();
  return bits > most / 2 ? bits - most - 1 : bits;
}

/// KHR_meshopt_compression, appendix B, filter 4.
template <typename T>
void decodeColors(std::vector<unsigned char>& data) {
  const auto most = static_cast<float>(std::numeric_limits<T>::max());
  for (std::size_t at = 0; at + 4 * sizeof(T) <= data.size(); at += 4 * sizeof(T)) {
    std::array<T, 4> color{};
    std::memcpy(color.data(), &data[at], sizeof(color));
    const int y = color[0];
    const int orange = signedValue(color[1]);
    const int green = signedValue(color[2]);
    // The highest bit of alpha tells how many bits the other channels have.
    const int scale = (1 << std::bit_width(color[3])) - 1;
    const int alpha = color[3] & (scale >> 1);
    const std::array<int, 4> wide{y + orange - green, y + green, y - orange - green,
                                  alpha << 1 | (alpha & 1)};
    const float factor = scale > 0 ? most / static_cast<float>(scale) : 0;
    for (std::size_t c = 0; c < 4; ++c) {
      const float value = std::round(static_cast<float>(wide[c]) * factor);
      color[c] = static_cast<T>(std::clamp(value, 0.0F, most));
    }
    std::memcpy(&data[at], color.data(), sizeof(color));
  }
}

/// A filter: the strides that it accepts, and what it does.
struct Filter {
  const char* name;
  bool (*allows)(std::size_t stride);
  void (*decode)(std::vector<unsigned char>& data, std::size_t stride);
};

bool isFourOrEight(std::size_t stride) {
  return stride == 4 || stride == 8;
}

constexpr std::array<Filter, 5> filters{{
    {"NONE", [](std::size_t) { return true; }, [](std::vector<unsigned char>&, std::size_t) {}},
    {"OCTAHEDRAL", isFourOrEight,
     [](std::vector<unsigned char>& data, std::size_t stride) {
       meshopt_decodeFilterOct(data.data(), data.size() / stride, stride);
     }},
    {"QUATERNION", [](std::size_t stride) { return stride == 8; },
     [](std::vector<unsigned char>& data, std::size_t stride) {
       meshopt_decodeFilterQuat(data.data(), data.size() / stride, stride);
     }},
    {"EXPONENTIAL", [](std::size_t stride) { return stride % 4 == 0; },
     [](std::vector<unsigned char>& data, std::size_t stride) {
       meshopt_decodeFilterExp(data.data(), data.size() / stride, stride);
     }},
    {"COLOR", isFourOrEight,
     [](std::vector<unsigned char>& data, std::size_t stride) {
       stride == 4 ? decodeColors<std::uint8_t>(data) : decodeColors<std::uint16_t>(data);
     }},
}};

template <typename Named, std::size_t Count>
const Named& named(const Input& input, const std::array<Named, Count>& all, const char* what,
                   const Compression& of, const std::string& name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Named& one) { return name == one.name; });
  if (found == all.end()) {
    failGltf(input, fmt::format("{} is compressed with the {} '{}', which does not exist", of.view,
                                what, cleanText(name, 30)));
  }
  return *found;
}

std::size_t numberOf(const Input& input, const tinygltf::Value& extension, const char* key,
                     const std::string& view, std::optional<int> otherwise = std::nullopt) {
  int number = otherwise.value_or(-1);
  if (extension.Has(key)) {
    const tinygltf::Value& value = extension.Get(key);
    number = value.IsInt() ? value.GetNumberAsInt() : -1;
  }
  if (number < 0) {
    failGltf(input, fmt::format("{} is compressed, but does not say its '{}'", view, key));
  }
  return static_cast<std::size_t>(number);
}

std::string textOf(const tinygltf::Value& extension, const char* key, const char* otherwise) {
  if (!extension.Has(key)) return otherwise;
  const tinygltf::Value& value = extension.Get(key);
  return value.IsString() ? value.Get<std::string>() : "";
}

Compression compressionOf(const GltfDecoded& decoded, const tinygltf::Value& extension,
                          std::size_t index) {
  const Input& input = decoded.input();
  Compression of;
  of.view = fmt::format("buffer view {}", index);
  const auto number = [&](const char* key) { return numberOf(input, extension, key, of.view); };
  const std::size_t buffer = number("buffer");
  const std::size_t offset = numberOf(input, extension, "byteOffset", of.view, 0);
  of.bytes = decoded.compressed(static_cast<int>(buffer), offset, number("byteLength"), of.view);
  of.count = number("count");
  of.stride = number("byteStride");
  of.mode = textOf(extension, "mode", "");
  of.filter = textOf(extension, "filter", "NONE");
  return of;
}

/// Checks what the extension requires of a view, and that so few bytes can yield so many.
void check(const Input& input, const Compression& of, const tinygltf::BufferView& view) {
  const Mode& mode = named(input, modes, "mode", of, of.mode);
  const Filter& filter = named(input, filters, "filter", of, of.filter);
  const bool attributes = &mode == modes.data();
  const bool fits = attributes ? of.stride >= 4 && of.stride <= 256 && of.stride % 4 == 0
                               : of.stride == 2 || of.stride == 4;
  if (!fits || !filter.allows(of.stride)) {
    failGltf(input, fmt::format("{} is compressed in elements of {} bytes, which mode {} with "
                                "filter {} does not allow",
                                of.view, of.stride, of.mode, of.filter));
  }
  if (!attributes && &filter != filters.data()) {
    failGltf(input, fmt::format("{} is compressed with filter {}, which mode {} does not allow",
                                of.view, of.filter, of.mode));
  }
  if (of.mode == "TRIANGLES" && of.count % 3 != 0) {
    failGltf(input,
             fmt::format("{} is compressed as triangles, but has {} indices", of.view, of.count));
  }
  const std::size_t bytes = of.count * of.stride;
  if (view.byteLength != bytes || (view.byteStride != 0 && view.byteStride != of.stride)) {
    failGltf(input, fmt::format("{} does not have the {} elements of {} bytes that are compressed "
                                "in it",
                                of.view, of.count, of.stride));
  }
  if (bytes / mode.mostOfOneByte > of.bytes.size()) {
    failGltf(input, fmt::format("{} promises {} bytes of {} compressed ones", of.view, bytes,
                                of.bytes.size()));
  }
}

/// False for a stream that is damaged.
bool decode(const Compression& of, std::vector<unsigned char>& data) {
  if (of.mode == "ATTRIBUTES") return decodeMeshoptAttributes(of.bytes, of.stride, data);
  const int problem = of.mode == "TRIANGLES"
                          ? meshopt_decodeIndexBuffer(data.data(), of.count, of.stride,
                                                      of.bytes.data(), of.bytes.size())
                          : meshopt_decodeIndexSequence(data.data(), of.count, of.stride,
                                                        of.bytes.data(), of.bytes.size());
  return problem == 0;
}

void decodeView(GltfDecoded& decoded, const tinygltf::Value& extension, std::size_t index) {
  const Compression of = compressionOf(decoded, extension, index);
  tinygltf::BufferView& view = decoded.model().bufferViews[index];
  check(decoded.input(), of, view);
  decoded.reserve(view.byteLength, of.view);
  std::vector<unsigned char> data(view.byteLength);
  if (!decode(of, data)) {
    failGltf(decoded.input(), fmt::format("the compressed data of {} are damaged", of.view));
  }
  named(decoded.input(), filters, "filter", of, of.filter).decode(data, of.stride);
  view.buffer = decoded.addBuffer(std::move(data));
  view.byteOffset = 0;
}

}  // namespace

void decodeMeshopt(GltfDecoded& decoded) {
  for (std::size_t i = 0; i < decoded.model().bufferViews.size(); ++i) {
    for (const char* name : meshoptExtensions) {
      const auto& extensions = decoded.model().bufferViews[i].extensions;
      const auto found = extensions.find(name);
      if (found == extensions.end()) continue;
      decodeView(decoded, found->second, i);
      break;
    }
  }
}

}  // namespace opaline::scene
