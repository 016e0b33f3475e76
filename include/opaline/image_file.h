#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "opaline/export.h"
#include "opaline/file.h"
#include "opaline/image.h"

namespace opaline {

/// Writes a PNG with alpha. A note of printable ASCII is stored in it as the text "Opaline".
/// Returns the file's path and throws Error naming the file; see writeWhole().
OPALINE_API std::filesystem::path writePng(const Target& target, const Image8& image,
                                           std::string_view note = {});

/// Writes an EXR: scanlines, ZIP, float, channels R G B A with A = coverage. The note is its
/// attribute "opaline".
OPALINE_API std::filesystem::path writeExr(const Target& target, const Image& image,
                                           std::string_view note = {});

/// The note of a .png or .exr file; nothing if there is no note or no such file.
OPALINE_API std::optional<std::string> readImageNote(const std::filesystem::path& file);

/// What happens to negative numbers in a file that is read.
enum class Negatives { BecomeZero, Stay };

/// Reads an .exr or .hdr (Radiance RGBE) file of at most 16384 × 16384 finite pixels.
OPALINE_API Image readHdrImage(const std::filesystem::path& file,
                               Negatives negatives = Negatives::BecomeZero);

/// Reads any kind of PNG of at most 16384 × 16384 pixels; A is 1 if it has no alpha. Values are as
/// stored, sRGB-encoded, divided by the largest that the file's depth allows: in [0,1].
OPALINE_API Image readPng(const std::filesystem::path& file);

/// Whether a .png or .exr file as this library writes it exists, is complete and has that size.
/// Checks header, table of blocks and end, not the pixels.
OPALINE_API bool isWholeImage(const std::filesystem::path& file, int width, int height);

}  // namespace opaline
