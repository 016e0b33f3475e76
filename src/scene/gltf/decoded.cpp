#include "scene/gltf/decoded.h"

#include <fmt/format.h>

#include <utility>

namespace opaline::scene {

namespace {

constexpr std::size_t mostBytes = 1'000'000'000;

}  // namespace

void GltfDecoded::reserve(std::size_t bytes, std::string_view whose) {
  if (bytes > mostBytes - reserved_) {
    failGltf(input_, fmt::format("with {} its compressed data grow to more than {} bytes", whose,
                                 mostBytes));
  }
  reserved_ += bytes;
}

int GltfDecoded::addBuffer(std::vector<unsigned char>&& data) {
  tinygltf::Buffer buffer;
  buffer.data = std::move(data);
  model_.buffers.push_back(std::move(buffer));
  return static_cast<int>(model_.buffers.size()) - 1;
}

std::span<const unsigned char> GltfDecoded::compressed(int buffer, std::size_t offset,
                                                       std::size_t length,
                                                       std::string_view whose) const {
  if (buffer < 0 || static_cast<std::size_t>(buffer) >= model_.buffers.size()) {
    failGltf(input_, fmt::format("{} names a buffer that does not exist", whose));
  }
  const std::vector<unsigned char>& data = model_.buffers[static_cast<std::size_t>(buffer)].data;
  if (offset > data.size() || length > data.size() - offset) {
    failGltf(input_, fmt::format("{} reaches beyond the end of its compressed buffer", whose));
  }
  return std::span(data).subspan(offset, length);
}

}  // namespace opaline::scene
