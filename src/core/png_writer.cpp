#include <fmt/format.h>
#include <stb_image_write.h>

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "core/sound_image.h"
#include "opaline/error.h"
#include "opaline/file.h"
#include "opaline/image_file.h"

namespace opaline {

namespace {

void appendBigEndian(std::string& to, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) to += static_cast<char>(value >> shift & 255U);
}

/// PNG specification, annex D.
std::uint32_t cyclicRedundancy(std::string_view bytes) {
  std::uint32_t crc = ~0U;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1U ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~crc;
}

/// PNG specification, section 11.3.4.3.
std::string textChunk(std::string_view note) {
  const std::string body = fmt::format("tEXtOpaline{}{}", '\0', note);
  std::string chunk;
  appendBigEndian(chunk, static_cast<std::uint32_t>(body.size() - 4));
  chunk += body;
  appendBigEndian(chunk, cyclicRedundancy(body));
  return chunk;
}

}  // namespace

std::filesystem::path writePng(const Target& target, const Image8& image, std::string_view note) {
  constexpr std::size_t headerEnd = 8 + 25;  // the signature and IHDR, which come first
  constexpr int channels = 4;
  core::requireSound(image);
  // stb_image_write counts bytes in int; its compressor may need a little more than the pixels.
  if (image.rgba.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()) / 4 * 3) {
    throw Error(fmt::format("Cannot write {}: {}x{} pixels are too many for PNG; use EXR.",
                            target.path.string(), image.width, image.height));
  }
  requireWritable(target);
  std::string encoded;
  const auto append = [](void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                               static_cast<std::size_t>(size));
  };
  const int done = stbi_write_png_to_func(append, &encoded, image.width, image.height, channels,
                                          image.rgba.data(), image.width * channels);
  if (done == 0 || encoded.empty()) {
    throw Error(fmt::format("Cannot write {}: there is not enough memory.", target.path.string()));
  }
  if (!note.empty()) encoded.insert(headerEnd, textChunk(note));
  return writeWhole(target, encoded);
}

}  // namespace opaline
