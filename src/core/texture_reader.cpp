#include <fmt/format.h>
#include <stb_image.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "core/hdr_readers.h"
#include "core/stb_memory.h"
#include "core/texture_file.h"
#include "core/webp_reader.h"

namespace opaline::core {

namespace {

using namespace std::string_view_literals;

bool startsWith(std::span<const std::byte> bytes, std::string_view magic) {
  const auto same = [](char a, std::byte b) { return static_cast<std::byte>(a) == b; };
  return bytes.size() >= magic.size() &&
         std::equal(magic.begin(), magic.end(), bytes.begin(), same);
}

// The most pixels that one byte can encode. Deflate (RFC 1951) expands a byte to at most 1032, and
// a pixel takes at least an eighth of a byte. JPEG needs two bits for a component's 64 pixels.
constexpr std::size_t mostOfPngByte = std::size_t{1032} * 8;
constexpr std::size_t mostOfJpegByte = 1024;
constexpr std::string_view jpegStart = "\xff\xd8\xff"sv;

std::size_t mostPixels(const std::filesystem::path& file, std::span<const std::byte> bytes) {
  if (startsWith(bytes, "\x89PNG\r\n\x1a\n"sv)) return mostOfPngByte * bytes.size();
  if (startsWith(bytes, jpegStart)) return mostOfJpegByte * bytes.size();
  failToReadImage(file, bytes.empty() ? "it is empty" : "it is neither PNG nor JPEG nor WebP");
}

/// The tables of Huffman codes in a JPEG file (ITU T.81, annex B), in the order in which stb_image
/// reads them. stb_image leaves its memory if a table has too many codes, or if a scan names a
/// table that is missing.
class JpegTables {
 public:
  explicit JpegTables(std::span<const std::byte> bytes) : bytes_(bytes) {}

  bool areSound() {
    at_ = 2;  // after the start of the image
    while (const std::optional<unsigned> marker = nextMarker()) {
      if (*marker == endOfImage) return true;
      const unsigned length = twoBytes();
      if (length < 2 || at_ > bytes_.size()) return true;  // stb_image itself finds such damage
      const std::size_t end = at_ + length - 2;
      if (*marker == progressiveFrame) progressive_ = true;
      if (*marker == huffmanTables && !tablesFit(end)) return false;
      inScan_ = *marker == startOfScan;
      if (inScan_ && !scanHasTables()) return false;
      at_ = end;
    }
    return true;
  }

 private:
  static constexpr unsigned progressiveFrame = 0xC2;
  static constexpr unsigned huffmanTables = 0xC4;
  static constexpr unsigned endOfImage = 0xD9;
  static constexpr unsigned startOfScan = 0xDA;
  // F.1.2 allows at most 176, and to stb_image the index of the 256th means none.
  static constexpr unsigned mostCodes = 255;

  unsigned byte() {
    const unsigned value = at_ < bytes_.size() ? std::to_integer<unsigned>(bytes_[at_]) : 0;
    ++at_;
    return value;
  }

  unsigned twoBytes() {
    const unsigned high = byte();
    return high << 8U | byte();
  }

  /// In a scan, 0xFF followed by zero is a value, and there are restart markers.
  std::optional<unsigned> nextMarker() {
    while (at_ < bytes_.size()) {
      if (byte() != 0xFF) continue;
      unsigned marker = 0xFF;
      while (marker == 0xFF && at_ < bytes_.size()) marker = byte();
      const bool ofScan = marker == 0 || (marker >= 0xD0 && marker <= 0xD7);
      if (!inScan_ || !ofScan) return marker;
    }
    return std::nullopt;
  }

  bool tablesFit(std::size_t end) {
    while (at_ < end) {
      there_.set(byte() & 0x1FU);  // its class and number
      unsigned codes = 0;
      for (int bits = 1; bits <= 16; ++bits) codes += byte();
      if (codes > mostCodes) return false;
      at_ += codes;
    }
    return at_ == end;
  }

  bool scanHasTables() {
    constexpr unsigned mostComponents = 4;
    const unsigned components = byte();
    if (components > mostComponents) return true;  // as above
    std::array<unsigned, mostComponents> tables{};
    for (unsigned i = 0; i < components; ++i) {
      byte();  // the component's name
      tables.at(i) = byte();
    }
    const bool first = byte() == 0;  // of the coefficients
    byte();
    const bool refined = byte() >= 0x10;
    const bool needsDc = !progressive_ || (first && !refined);
    const bool needsAc = !progressive_ || !first;
    for (unsigned i = 0; i < components; ++i) {
      if (needsDc && !there_.test(tables.at(i) >> 4U)) return false;
      if (needsAc && !there_.test(0x10U | (tables.at(i) & 0xFU))) return false;
    }
    return true;
  }

  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
  std::bitset<32> there_;  // by class, then number
  bool progressive_ = false;
  bool inScan_ = false;
};

}  // namespace

void requireTextureSize(const std::filesystem::path& file, int width, int height) {
  requireImageSize(file, width, height);
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (pixels > mostTexturePixels)
    failToReadImage(file, fmt::format("it has {}x{} pixels; a texture may have {} million", width,
                                      height, mostTexturePixels >> 20U));
}

TexturePixels readTexture(const std::filesystem::path& file, std::span<const std::byte> bytes) {
  if (isWebp(bytes)) return readWebp(file, bytes);
  constexpr std::size_t mostBytes = std::size_t{1} << 30U;
  const std::size_t most = mostPixels(file, bytes);
  if (bytes.size() > mostBytes) failToReadImage(file, "it is longer than a gigabyte");
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const auto size = static_cast<int>(bytes.size());
  const bool jpeg = startsWith(bytes, jpegStart);
  if (jpeg && !JpegTables(bytes).areSound())
    failToReadImage(file, "it is damaged: a table of Huffman codes is missing or too long");
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
  requireTextureSize(file, texture.width, texture.height);
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
