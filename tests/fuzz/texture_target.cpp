#include <gtest/gtest.h>

#include <span>

#include "core/texture_file.h"
#include "reading.h"

// PNG, JPEG or WebP.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace opaline;
  fuzz::expectReadOrRefused([&] {
    const TexturePixels texture = core::readTexture("a", std::as_bytes(std::span(data, size)));
    EXPECT_EQ(texture.rgba.size(), std::size_t{4} * static_cast<std::size_t>(texture.width) *
                                       static_cast<std::size_t>(texture.height));
  });
  return 0;
}
