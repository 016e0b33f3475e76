#include "scene/gltf/accessor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

namespace opaline::scene {

namespace {

constexpr std::size_t mostNumbers = 300'000'000;
/// Most elements of an accessor without bytes of its own. All but the sparse ones are zero.
constexpr std::size_t mostZeroElements = 1'000'000;

template <typename T>
T load(const unsigned char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));  // glTF is little-endian, as is every supported host
  return value;
}

template <typename T>
float normalised(const unsigned char* bytes) {
  const float value =
      static_cast<float>(load<T>(bytes)) / static_cast<float>(std::numeric_limits<T>::max());
  return std::max(value, -1.0F);
}

float floatAt(const unsigned char* bytes, int type, bool normalise) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return normalise ? normalised<std::int8_t>(bytes)
                       : static_cast<float>(load<std::int8_t>(bytes));
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return normalise ? normalised<std::uint8_t>(bytes)
                       : static_cast<float>(load<std::uint8_t>(bytes));
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return normalise ? normalised<std::int16_t>(bytes)
                       : static_cast<float>(load<std::int16_t>(bytes));
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return normalise ? normalised<std::uint16_t>(bytes)
                       : static_cast<float>(load<std::uint16_t>(bytes));
    case TINYGLTF_COMPONENT_TYPE_INT:
      return static_cast<float>(load<std::int32_t>(bytes));
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return normalise ? normalised<std::uint32_t>(bytes)
                       : static_cast<float>(load<std::uint32_t>(bytes));
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return load<float>(bytes);
    case TINYGLTF_COMPONENT_TYPE_DOUBLE:
      return static_cast<float>(load<double>(bytes));
    default:
      return 0;
  }
}

std::optional<std::uint32_t> toInteger(const unsigned char* bytes, int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return load<std::uint8_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return load<std::uint16_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return load<std::uint32_t>(bytes);
    default:
      return std::nullopt;
  }
}

}  // namespace

const tinygltf::Accessor& GltfAccessors::at(int accessor) const {
  if (accessor < 0 || static_cast<std::size_t>(accessor) >= model_.accessors.size()) {
    failGltf(input_, fmt::format("accessor {} does not exist", accessor));
  }
  return model_.accessors[static_cast<std::size_t>(accessor)];
}

void GltfAccessors::spend(std::size_t numbers) {
  if (numbers > mostNumbers - numbersRead_) {
    failGltf(input_, "its accessors are used for too many numbers");
  }
  numbersRead_ += numbers;
}

std::size_t GltfAccessors::countOf(int accessor) const {
  return at(accessor).count;
}

const unsigned char* GltfAccessors::bytes(int view, std::size_t offset, std::size_t count,
                                          std::size_t elementBytes,
                                          std::size_t& strideBytes) const {
  if (view < 0 || static_cast<std::size_t>(view) >= model_.bufferViews.size()) {
    failGltf(input_, fmt::format("buffer view {} does not exist", view));
  }
  const tinygltf::BufferView& of = model_.bufferViews[static_cast<std::size_t>(view)];
  if (of.buffer < 0 || static_cast<std::size_t>(of.buffer) >= model_.buffers.size()) {
    failGltf(input_, fmt::format("buffer view {} names a buffer that does not exist", view));
  }
  const std::vector<unsigned char>& data = model_.buffers[static_cast<std::size_t>(of.buffer)].data;
  if (of.byteOffset > data.size() || of.byteLength > data.size() - of.byteOffset) {
    failGltf(input_, fmt::format("buffer view {} reaches beyond the end of its buffer", view));
  }
  strideBytes = of.byteStride != 0 ? of.byteStride : elementBytes;
  if (strideBytes < elementBytes) {
    failGltf(input_, fmt::format("the elements of buffer view {} overlap", view));
  }
  const bool fits =
      count == 0 || (offset <= of.byteLength && elementBytes <= of.byteLength - offset &&
                     count - 1 <= (of.byteLength - offset - elementBytes) / strideBytes);
  if (!fits) {
    failGltf(input_, fmt::format("an accessor reaches beyond the end of buffer view {}", view));
  }
  return data.data() + of.byteOffset + (count == 0 ? 0 : offset);
}

template <typename T, typename Convert>
std::vector<T> GltfAccessors::read(int index, int components, std::optional<std::size_t> count,
                                   Convert&& convert) {
  const tinygltf::Accessor& accessor = at(index);
  const int size = tinygltf::GetComponentSizeInBytes(static_cast<unsigned>(accessor.componentType));
  const int own = tinygltf::GetNumComponentsInType(static_cast<unsigned>(accessor.type));
  if (size <= 0 || own != components) {
    failGltf(input_,
             fmt::format("accessor {} has elements of another type than its use needs", index));
  }
  if (count && accessor.count != *count) {
    failGltf(input_, fmt::format("accessor {} has {} elements where {} are needed", index,
                                 accessor.count, *count));
  }
  const auto width = static_cast<std::size_t>(components);
  const auto componentBytes = static_cast<std::size_t>(size);
  const unsigned char* from = nullptr;
  std::size_t stride = 0;
  if (accessor.bufferView != -1) {
    from = bytes(accessor.bufferView, accessor.byteOffset, accessor.count, width * componentBytes,
                 stride);
  } else if (!count && accessor.count > mostZeroElements) {
    failGltf(input_, fmt::format("accessor {} promises {} elements without any bytes", index,
                                 accessor.count));
  }
  if (accessor.count > mostNumbers / width) spend(mostNumbers + 1);
  spend(accessor.count * width);
  std::vector<T> values(accessor.count * width);
  const auto convertElement = [&](const unsigned char* element, std::size_t to) {
    for (std::size_t c = 0; c < width; ++c) {
      values[to * width + c] = convert(accessor, element + c * componentBytes);
    }
  };
  if (from != nullptr) {
    for (std::size_t i = 0; i < accessor.count; ++i) convertElement(from + i * stride, i);
  }
  if (!accessor.sparse.isSparse) return values;

  const auto& sparse = accessor.sparse;
  const int indexSize =
      tinygltf::GetComponentSizeInBytes(static_cast<unsigned>(sparse.indices.componentType));
  // Versions of the library differ in whether sparse offsets have a sign.
  if (sparse.count < 0 || static_cast<std::size_t>(sparse.count) > accessor.count ||
      std::cmp_less(sparse.indices.byteOffset, 0) || std::cmp_less(sparse.values.byteOffset, 0) ||
      indexSize <= 0) {
    failGltf(input_, fmt::format("the sparse part of accessor {} must replace 0 to {} elements, by "
                                 "unsigned indices, from offsets of at least 0",
                                 index, accessor.count));
  }
  const auto changed = static_cast<std::size_t>(sparse.count);
  std::size_t indexStride = 0;
  std::size_t valueStride = 0;
  const unsigned char* places =
      bytes(sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset), changed,
            static_cast<std::size_t>(indexSize), indexStride);
  const unsigned char* news =
      bytes(sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset), changed,
            width * componentBytes, valueStride);
  for (std::size_t i = 0; i < changed; ++i) {
    const auto place = toInteger(places + i * indexStride, sparse.indices.componentType);
    if (!place || *place >= accessor.count) {
      failGltf(input_, fmt::format("the sparse part of accessor {} is out of range", index));
    }
    convertElement(news + i * valueStride, *place);
  }
  return values;
}

std::vector<float> GltfAccessors::floats(int accessor, int components,
                                         std::optional<std::size_t> count) {
  return read<float>(accessor, components, count,
                     [](const tinygltf::Accessor& of, const unsigned char* bytes) {
                       return floatAt(bytes, of.componentType, of.normalized);
                     });
}

std::vector<std::uint32_t> GltfAccessors::integers(int accessor, int components,
                                                   std::optional<std::size_t> count) {
  return read<std::uint32_t>(accessor, components, count,
                             [&](const tinygltf::Accessor& of, const unsigned char* bytes) {
                               const auto value = toInteger(bytes, of.componentType);
                               if (!value) {
                                 failGltf(input_, fmt::format("accessor {} must hold whole numbers "
                                                              "that are at least 0",
                                                              accessor));
                               }
                               return *value;
                             });
}

}  // namespace opaline::scene
