#include <fmt/format.h>
#include <stb_image.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string_view>

#include "core/hdr_readers.h"
#include "core/stb_memory.h"
#include "core/texture_file.h"

namespace opaline::core {

namespace {

using namespace std::string_view_literals;

bool startsWith(std::span<const std::byte> bytes, std::string_view magic) {
  const auto same = [](char a, std::byte b) { return static_cast<std::byte>(a) == b; };
  return bytes.size() >= magic.size() &&
         std::equal(magic.begin(), magic.end(), bytes.begin(), same);
}

// Pixels that a byte can hold. Deflate (RFC 1951) makes at most 1032 bytes of one, and a pixel
// takes an eighth of one or more; JPEG needs two bits for a component's 64 pixels.
constexpr std::size_t mostOfPngByte = std::size_t{1032} * 8;
constexpr std::size_t mostOfJpegByte = 1024;

std::size_t mostPixels(const std::filesystem::path& file, std::span<const std::byte> bytes) {
  if (startsWith(bytes, "\x89PNG\r\n\x1a\n"sv)) return mostOfPngByte * bytes.size();
  if (startsWith(bytes, "\xff\xd8\xff"sv)) return mostOfJpegByte * bytes.size();
  failToReadImage(file, bytes.empty() ? "it is empty" : "it is neither PNG nor JPEG");
}

}  // namespace

TexturePixels readTexture(const std::filesystem::path& file, std::span<const std::byte> bytes) {
  constexpr std::size_t mostBytes = std::size_t{1} << 30U;
  const std::size_t most = mostPixels(file, bytes);
  if (bytes.size() > mostBytes) failToReadImage(file, "it is longer than a gigabyte");
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const auto size = static_cast<int>(bytes.size());
  TexturePixels texture;
  int channels = 0;
  const auto incomplete = [&] {
    failToReadImage(file, fmt::format("it is damaged (stb_image says: {})", stbi_failure_reason()));
  };
  if (stbi_info_from_memory(data, size, &texture.width, &texture.height, &channels) == 0)
    incomplete();
  requireImageSize(file, texture.width, texture.height);
  const std::size_t pixels =
      static_cast<std::size_t>(texture.width) * static_cast<std::size_t>(texture.height);
  if (pixels > most) failToReadImage(file, "its header claims more pixels than the file can hold");
  if (pixels > mostTexturePixels)
    failToReadImage(file, fmt::format("it has {}x{} pixels; a texture may have {} million",
                                      texture.width, texture.height, mostTexturePixels >> 20U));
  constexpr std::size_t decoderBytesOfPixel = 32;
  const StbMemoryLimit limit(decoderBytesOfPixel * pixels + 2 * bytes.size() + (1U << 20U));
  const std::unique_ptr<stbi_us, decltype(&stbi_image_free)> decoded(
      stbi_load_16_from_memory(data, size, &texture.width, &texture.height, &channels, 4),
      stbi_image_free);
  if (!decoded) incomplete();
  texture.rgba.assign(decoded.get(), decoded.get() + 4 * pixels);
  texture.name = file.filename().string();
  return texture;
}

}  // namespace opaline::core
