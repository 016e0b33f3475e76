#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "opaline/image.h"

namespace opaline::core {

bool isWebp(std::span<const std::byte> bytes);

/// Reads a still WebP picture like readTexture(). Its compression has no bound on pixels per byte,
/// so mostTexturePixels is the only limit.
TexturePixels readWebp(const std::filesystem::path& file, std::span<const std::byte> bytes);

}  // namespace opaline::core
