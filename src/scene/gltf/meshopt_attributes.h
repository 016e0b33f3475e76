#pragma once

#include <cstddef>
#include <span>

namespace opaline::scene {

/// Decodes a stream of mode ATTRIBUTES, version 0 or 1 (KHR_meshopt_compression, appendix A, mode
/// 0). The stride is a multiple of 4 up to 256 and divides the size of `elements`. Returns false
/// for a stream that is damaged.
bool decodeMeshoptAttributes(std::span<const unsigned char> stream, std::size_t stride,
                             std::span<unsigned char> elements);

}  // namespace opaline::scene
