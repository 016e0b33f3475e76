#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/file.h"
#include "opaline/image.h"

namespace opaline::core {

/// Eight-bit sRGB pixels with straight alpha, rows from top to bottom.
struct Image8 {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

/// PNG with alpha. A note of printable ASCII is kept in it as the text "Opaline". Returns where it
/// is and throws Error naming the file; see writeWhole.
std::filesystem::path writePng(const Target& target, const Image8& image,
                               std::string_view note = {});

/// EXR, scanline, ZIP, float, channels R G B A with A = coverage; the note is its attribute
/// "opaline".
std::filesystem::path writeExr(const Target& target, const Image& image,
                               std::string_view note = {});

/// The note of a .png or .exr file; nothing where there is none, or no such file.
std::optional<std::string> readImageNote(const std::filesystem::path& file);

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
