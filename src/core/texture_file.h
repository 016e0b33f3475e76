#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "opaline/image.h"

namespace opaline::core {

/// The largest number of pixels of a texture: 8192 × 8192.
inline constexpr std::size_t mostTexturePixels = std::size_t{1} << 26U;

/// Throws Error for a picture that has more pixels or no sensible size.
void requireTextureSize(const std::filesystem::path& file, int width, int height);

/// A PNG, JPEG or WebP picture as it is stored. Throws Error, naming the file, for anything else,
/// for pictures that end early, and, before memory is taken, for those that claim more pixels than
/// mostTexturePixels or than their bytes can hold.
TexturePixels readTexture(const std::filesystem::path& file, std::span<const std::byte> bytes);

}  // namespace opaline::core
