#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "opaline/export.h"
#include "opaline/file.h"
#include "opaline/image.h"

namespace opaline {

/// PNG with alpha. A note of printable ASCII is kept in it as the text "Opaline". Returns where it
/// is and throws Error naming the file; see writeWhole.
OPALINE_API std::filesystem::path writePng(const Target& target, const Image8& image,
                                           std::string_view note = {});

/// EXR, scanline, ZIP, float, channels R G B A with A = coverage; the note is its attribute
/// "opaline".
OPALINE_API std::filesystem::path writeExr(const Target& target, const Image& image,
                                           std::string_view note = {});

/// The note of a .png or .exr file; nothing where there is none, or no such file.
OPALINE_API std::optional<std::string> readImageNote(const std::filesystem::path& file);

/// What becomes of negative numbers in a file that is read.
enum class Negatives { BecomeZero, Stay };

/// .exr or .hdr (Radiance RGBE), at most 16384 × 16384 and finite.
OPALINE_API Image readHdrImage(const std::filesystem::path& file,
                               Negatives negatives = Negatives::BecomeZero);

/// PNG of at most 16384 × 16384, of any kind; without alpha all is covered. Values are those
/// stored, sRGB-encoded, over the largest the file's depth allows: in [0,1].
OPALINE_API Image readPng(const std::filesystem::path& file);

/// Whether a .png or .exr file of that size and ours in kind is there from its first byte to its
/// last. Looks at header, table of blocks and end, not at the pixels.
OPALINE_API bool isWholeImage(const std::filesystem::path& file, int width, int height);

}  // namespace opaline
