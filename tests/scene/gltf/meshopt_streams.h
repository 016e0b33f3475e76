#pragma once

#include <meshoptimizer.h>

#include <cstddef>
#include <vector>

namespace opaline::test {

using Bytes = std::vector<unsigned char>;

/// Encodes attributes by meshoptimizer.
inline Bytes encodedAttributes(const void* elements, std::size_t count, std::size_t stride) {
  Bytes bytes(meshopt_encodeVertexBufferBound(count, stride));
  bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), elements, count, stride));
  return bytes;
}

template <typename T>
Bytes encodedAttributes(const std::vector<T>& values, std::size_t stride) {
  return encodedAttributes(values.data(), values.size() * sizeof(T) / stride, stride);
}

}  // namespace opaline::test
