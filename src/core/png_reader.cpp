#include <fmt/format.h>
#include <stb_image.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string_view>

#include "core/hdr_readers.h"
#include "core/stb_memory.h"
#include "opaline/file.h"
#include "opaline/image_file.h"

namespace opaline {

namespace {

using namespace std::string_view_literals;

/// PNG specification, sections 5.2 and 11.2.2: signature, then IHDR before anything else.
struct PngHeader {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t bitsPerChannel = 0;
};

PngHeader readHeader(const std::filesystem::path& file, const std::vector<std::byte>& bytes) {
  constexpr std::string_view start = "\x89PNG\r\n\x1a\n\0\0\0\rIHDR"sv;
  constexpr std::size_t headerBytes = start.size() + 9;
  const auto same = [](char a, std::byte b) { return static_cast<std::byte>(a) == b; };
  if (bytes.size() < headerBytes || !std::equal(start.begin(), start.end(), bytes.begin(), same)) {
    core::failToReadImage(
        file, bytes.empty() ? "it is empty" : "it is not a PNG file, whatever its name says");
  }
  const auto bigEndian = [&](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      value = value << 8U | std::to_integer<std::uint32_t>(bytes[at + i]);
    }
    return value;
  };
  return {bigEndian(start.size()), bigEndian(start.size() + 4),
          std::to_integer<std::uint32_t>(bytes[start.size() + 8])};
}

/// The least and the largest size of rows before compression: one byte of filter, then pixels of 1
/// to 64 bits.
struct RawBytes {
  std::size_t least;
  std::size_t most;
};

RawBytes rawBytes(const PngHeader& header) {
  const std::size_t rows = header.height;
  const std::size_t width = header.width;
  const std::size_t bits = header.bitsPerChannel;
  return {rows * (1 + width * bits / 8), 2 * rows * (1 + width * 8)};
}

}  // namespace

Image readPng(const std::filesystem::path& file) {
  constexpr std::size_t limitBytes = std::size_t{1} << 30U;
  // Deflate (RFC 1951) expands two bits to at most 258 bytes.
  constexpr std::size_t mostExpansion = 1032;
  constexpr std::size_t tables = std::size_t{1} << 16U;

  const std::vector<std::byte> bytes = readFile(file, limitBytes);
  const PngHeader header = readHeader(file, bytes);
  core::requireImageSize(file, header.width, header.height);
  const RawBytes raw = rawBytes(header);
  if (raw.least > mostExpansion * bytes.size()) {
    core::failToReadImage(file, "its header claims more pixels than the file can hold");
  }

  const core::StbMemoryLimit limit(std::max(raw.most, 2 * bytes.size()) + tables);
  int width = 0;
  int height = 0;
  int channels = 0;
  const std::unique_ptr<stbi_us, decltype(&stbi_image_free)> pixels(
      stbi_load_16_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                               static_cast<int>(bytes.size()), &width, &height, &channels, 4),
      stbi_image_free);
  if (!pixels) {
    core::failToReadImage(file, fmt::format("it is not a complete PNG file (stb_image says: {})",
                                            stbi_failure_reason()));
  }
  Image image(width, height);
  std::transform(pixels.get(), pixels.get() + image.rgba.size(), image.rgba.begin(),
                 [](stbi_us value) { return static_cast<float>(value) / 65535.0F; });
  return image;
}

}  // namespace opaline
