#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stb_image_write.h>
#include <webp/encode.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/temporary_folder.h"
#include "core/texture_file.h"
#include "opaline/error.h"

namespace opaline {
namespace {

using Bytes = std::vector<std::byte>;

void append(void* to, void* data, int size) {
  const auto* bytes = static_cast<const std::byte*>(data);
  static_cast<Bytes*>(to)->insert(static_cast<Bytes*>(to)->end(), bytes, bytes + size);
}

Bytes png(int width, int height, int channels, const std::vector<std::uint8_t>& pixels) {
  Bytes bytes;
  stbi_write_png_to_func(append, &bytes, width, height, channels, pixels.data(), width * channels);
  return bytes;
}

Bytes webp(int width, int height, const std::vector<std::uint8_t>& rgba) {
  std::uint8_t* encoded = nullptr;
  const std::size_t size = WebPEncodeLosslessRGBA(rgba.data(), width, height, 4 * width, &encoded);
  const auto* begin = reinterpret_cast<const std::byte*>(encoded);
  const Bytes bytes(begin, begin + size);
  WebPFree(encoded);
  return bytes;
}

TEST(Texture, WebpIsReadAsItIsStored) {
  const auto texture = core::readTexture("a.webp", webp(2, 1, {0, 128, 255, 64, 1, 2, 3, 255}));
  EXPECT_EQ(texture.width, 2);
  EXPECT_EQ(texture.height, 1);
  const std::vector<std::uint16_t> expected{0,   128 * 257, 65535,   64 * 257,
                                            257, 2 * 257,   3 * 257, 65535};
  EXPECT_EQ(texture.rgba, expected);
}

// The header of a lossless picture (RFC 9649, section 3.4), followed by some bytes.
Bytes webpHead(unsigned width, unsigned height) {
  const std::uint32_t size = (width - 1) | (height - 1) << 14U;
  const std::string text = std::string("RIFF\x2c\0\0\0WEBPVP8L\x20\0\0\0\x2f", 21) +
                           std::string(reinterpret_cast<const char*>(&size), 4) +
                           std::string(27, '\0');
  const auto* begin = reinterpret_cast<const std::byte*>(text.data());
  return {begin, begin + text.size()};
}

// Uniform colours take no bits per pixel, so a small file may have any number of pixels.
TEST(Texture, WebpThatIsDamagedOrTooLargeIsRefused) {
  const Bytes whole = webp(16, 16, std::vector<std::uint8_t>(1024, 77));
  for (std::size_t size = 1; size < whole.size(); ++size)
    EXPECT_THROW(core::readTexture("a.webp", std::span(whole).first(size)), Error) << size;
  EXPECT_THAT(test::messageOf([&] { core::readTexture("a.webp", webpHead(16383, 4200)); }),
              testing::HasSubstr("16383x4200 pixels"));
}

TEST(Texture, PngIsReadAsItIsStored) {
  const auto texture = core::readTexture("a.png", png(2, 1, 4, {0, 128, 255, 64, 1, 2, 3, 255}));
  EXPECT_EQ(texture.width, 2);
  EXPECT_EQ(texture.height, 1);
  const std::vector<std::uint16_t> expected{0,   128 * 257, 65535,   64 * 257,
                                            257, 2 * 257,   3 * 257, 65535};
  EXPECT_EQ(texture.rgba, expected);
  EXPECT_EQ(texture.name, "a.png");
}

TEST(Texture, WithoutColourOrAlphaItIsGreyAndOpaque) {
  const auto texture = core::readTexture("a.png", png(1, 1, 1, {51}));
  EXPECT_EQ(texture.rgba, (std::vector<std::uint16_t>{51 * 257, 51 * 257, 51 * 257, 65535}));
}

TEST(Texture, JpegIsRead) {
  Bytes bytes;
  const std::vector<std::uint8_t> pixels(3 * 16 * 16, 200);
  stbi_write_jpg_to_func(append, &bytes, 16, 16, 3, pixels.data(), 95);
  const auto texture = core::readTexture("a.jpg", bytes);
  ASSERT_EQ(texture.rgba.size(), 4U * 256U);
  EXPECT_NEAR(texture.rgba[0] / 257, 200, 2);
}

TEST(Texture, WhatIsNoWholePictureIsAnError) {
  const Bytes whole = png(64, 64, 3, std::vector<std::uint8_t>(3 * 64 * 64, 7));
  for (const std::size_t size : {std::size_t{0}, std::size_t{5}, std::size_t{20}, whole.size() / 2})
    EXPECT_NE(test::messageOf([&] { core::readTexture("a.png", std::span(whole).first(size)); }),
              "")
        << size;
  const std::string text = "GIF89a, or anything else";
  EXPECT_NE(test::messageOf([&] { core::readTexture("a.gif", std::as_bytes(std::span(text))); }),
            "");
}

// The first Huffman table begins after the segment's length and the table's number.
TEST(Texture, TablesOfHuffmanCodesThatCannotBeAreAnError) {
  Bytes bytes;
  stbi_write_jpg_to_func(append, &bytes, 16, 16, 3, std::vector<std::uint8_t>(768, 200).data(), 95);
  const std::array<std::byte, 2> marker{std::byte{0xFF}, std::byte{0xC4}};
  const auto table = std::search(bytes.begin(), bytes.end(), marker.begin(), marker.end());
  ASSERT_NE(table, bytes.end());
  // A table that a scan names but nothing defines.
  *(table + 4) = std::byte{3};
  EXPECT_THAT(test::messageOf([&] { core::readTexture("a.jpg", bytes); }),
              testing::HasSubstr("Huffman"));
  std::fill_n(table + 5, 16, std::byte{255});
  EXPECT_THAT(test::messageOf([&] { core::readTexture("a.jpg", bytes); }),
              testing::HasSubstr("Huffman"));
}

TEST(Texture, SizesAreCheckedBeforeMemoryIsTaken) {
  Bytes bytes = png(8, 8, 3, std::vector<std::uint8_t>(3 * 64, 7));
  const auto claim = [&](std::uint32_t width, std::uint32_t height) {
    for (std::size_t i = 0; i < 4; ++i) {
      bytes[16 + i] = static_cast<std::byte>(width >> (24 - 8 * i));
      bytes[20 + i] = static_cast<std::byte>(height >> (24 - 8 * i));
    }
    return test::messageOf([&] { core::readTexture("a.png", bytes); });
  };
  EXPECT_NE(claim(60000, 60000), "");
  EXPECT_NE(claim(16384, 16384), "");
  EXPECT_NE(claim(0, 8), "");
}

}  // namespace
}  // namespace opaline
