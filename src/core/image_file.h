#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "opaline/image.h"

namespace opaline::core {

/// Eight-bit sRGB pixels with straight alpha, rows from top to bottom.
struct Image8 {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

/// PNG with alpha. Throws Error naming the file; see writeWhole.
void writePng(const std::filesystem::path& file, const Image8& image);

/// EXR, scanline, ZIP, float, channels R G B A with A = coverage.
void writeExr(const std::filesystem::path& file, const Image& image);

/// .exr or .hdr (Radiance RGBE), at most 16384 × 16384 and finite; negative values become 0.
Image readHdrImage(const std::filesystem::path& file);

/// Whether a .png or .exr file of that size and ours in kind is there from its first byte to its
/// last. Looks at header, table of blocks and end, not at the pixels.
bool isWholeImage(const std::filesystem::path& file, int width, int height);

}  // namespace opaline::core
