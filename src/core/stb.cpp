// The only place that compiles stb_image and stb_image_write; everyone else includes the headers.
// Our own code reads files, after checking their length, so functions that open files are left out.

#include "core/stb_memory.h"

#include <cstdlib>
#include <limits>

namespace opaline::core {

namespace {

constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();
thread_local std::size_t largestBlock = unlimited;

void* allocate(std::size_t bytes) {
  return bytes > largestBlock ? nullptr : std::malloc(bytes);
}

void* reallocate(void* block, std::size_t bytes) {
  return bytes > largestBlock ? nullptr : std::realloc(block, bytes);
}

}  // namespace

StbMemoryLimit::StbMemoryLimit(std::size_t largestBlockBytes) {
  largestBlock = largestBlockBytes;
}

StbMemoryLimit::~StbMemoryLimit() {
  largestBlock = unlimited;
}

}  // namespace opaline::core

#define STBI_MALLOC(bytes) opaline::core::allocate(bytes)
#define STBI_REALLOC(block, bytes) opaline::core::reallocate(block, bytes)
#define STBI_FREE(block) std::free(block)
#define STB_IMAGE_IMPLEMENTATION
#define STBI_NO_STDIO
#define STBI_FAILURE_USERMSG
// stb_image applies C-style casts to the results of the macros above.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#include <stb_image.h>
#pragma GCC diagnostic pop

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>
