#include "core/webp_reader.h"

#include <fmt/format.h>
#include <webp/decode.h>

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/hdr_readers.h"
#include "core/texture_file.h"

namespace opaline::core {

namespace {

bool holdsAt(std::span<const std::byte> bytes, std::size_t at, std::string_view text) {
  return bytes.size() >= at + text.size() &&
         std::equal(text.begin(), text.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                    [](char a, std::byte b) { return static_cast<std::byte>(a) == b; });
}

}  // namespace

bool isWebp(std::span<const std::byte> bytes) {
  return holdsAt(bytes, 0, "RIFF") && holdsAt(bytes, 8, "WEBP");
}

TexturePixels readWebp(const std::filesystem::path& file, std::span<const std::byte> bytes) {
  const auto* const data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(data, bytes.size(), &features) != VP8_STATUS_OK)
    failToReadImage(file, "it is damaged or incomplete");
  if (features.has_animation != 0) failToReadImage(file, "it is an animated picture");
  requireTextureSize(file, features.width, features.height);
  const std::size_t pixels =
      static_cast<std::size_t>(features.width) * static_cast<std::size_t>(features.height);
  std::vector<std::uint8_t> decoded(4 * pixels);
  if (WebPDecodeRGBAInto(data, bytes.size(), decoded.data(), decoded.size(), 4 * features.width) ==
      nullptr)
    failToReadImage(file, "it is damaged or incomplete");
  TexturePixels texture;
  texture.width = features.width;
  texture.height = features.height;
  constexpr std::uint16_t widened = 257;  // 255 becomes 65535
  texture.rgba.resize(decoded.size());
  std::transform(decoded.begin(), decoded.end(), texture.rgba.begin(),
                 [](std::uint8_t value) { return static_cast<std::uint16_t>(widened * value); });
  texture.name = file.filename().string();
  return texture;
}

}  // namespace opaline::core
