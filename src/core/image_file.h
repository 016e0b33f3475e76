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

enum class Negatives { BecomeZero, Stay };

/// .exr or .hdr (Radiance RGBE), at most 16384 × 16384 and finite.
Image readHdrImage(const std::filesystem::path& file, Negatives negatives = Negatives::BecomeZero);

/// PNG of at most 16384 × 16384, of any kind; without alpha all is covered. Values are those
/// stored, sRGB-encoded, over the largest the file's depth allows: in [0,1].
Image readPng(const std::filesystem::path& file);

/// Whether a .png or .exr file of that size and ours in kind is there from its first byte to its
/// last. Looks at header, table of blocks and end, not at the pixels.
bool isWholeImage(const std::filesystem::path& file, int width, int height);

}  // namespace opaline::core
