#pragma once

#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

#include "gpu/command_list.h"
#include "gpu/device.h"
#include "gpu/transfer.h"

namespace opaline::gpu {

template <typename T>
std::vector<T> as(const std::vector<std::byte>& bytes) {
  std::vector<T> values(bytes.size() / sizeof(T));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
  return values;
}

template <typename T>
std::vector<T> readAs(Device& device, Buffer& buffer) {
  return as<T>(readBuffer(device, buffer));
}

template <typename T>
std::vector<T> readAs(Device& device, GpuImage& image, std::size_t bytesPerTexel,
                      std::uint32_t layer = 0, std::uint32_t level = 0) {
  return as<T>(readImage(device, image, bytesPerTexel, layer, level));
}

template <typename T>
std::span<const std::byte> bytesOf(const std::vector<T>& values) {
  return std::as_bytes(std::span<const T>(values));
}

}  // namespace opaline::gpu
