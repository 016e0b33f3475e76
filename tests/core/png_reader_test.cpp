#include <gmock/gmock.h>

#include <cstdint>
#include <string>

#include "core/temporary_folder.h"
#include "opaline/image_file.h"

namespace opaline::core {
namespace {

using test::messageOf;
using test::readBytes;
using test::TemporaryFolder;
using test::writeBytes;
using testing::ElementsAre;
using testing::HasSubstr;

std::string bigEndian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 255U);
  return bytes;
}

const std::string fourZeros(4, '\0');

/// A chunk with a check sum of 0, which the reader ignores.
std::string chunk(const std::string& kind, const std::string& data) {
  return bigEndian(static_cast<std::uint32_t>(data.size())) + kind + data + fourZeros;
}

/// zlib (RFC 1950) around one stored block (RFC 1951, 3.2.4).
std::string stored(const std::string& data) {
  const auto length = static_cast<unsigned>(data.size());
  std::string bytes = "\x78\x01\x01";
  for (const unsigned value : {length, length >> 8U, ~length, ~length >> 8U}) {
    bytes += static_cast<char>(value & 255U);
  }
  return bytes + data + fourZeros;
}

std::string png(std::uint32_t width, std::uint32_t height, int depth, int colorType,
                const std::string& zlib) {
  const std::string header = bigEndian(width) + bigEndian(height) + static_cast<char>(depth) +
                             static_cast<char>(colorType) + std::string(3, '\0');
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("IDAT", zlib) + chunk("IEND", "");
}

Image read(const std::string& bytes) {
  const TemporaryFolder folder;
  writeBytes(folder / "a.png", bytes);
  return readPng(folder / "a.png");
}

TEST(PngReader, ReadsWhatTheWriterWrote) {
  const TemporaryFolder folder;
  Image8 image{16, 16, {}};
  for (int i = 0; i < 16 * 16 * 4; ++i) image.rgba.push_back(static_cast<std::uint8_t>(i * 37));
  writePng(folder / "a.png", image);
  const Image back = readPng(folder / "a.png");
  ASSERT_EQ(back.width, 16);
  ASSERT_EQ(back.height, 16);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    EXPECT_FLOAT_EQ(back.rgba[i], static_cast<float>(image.rgba[i]) / 255.0F);
  }
}

TEST(PngReader, NamesWhatItCannotRead) {
  const TemporaryFolder folder;
  const auto message = [&](const std::string& bytes) {
    writeBytes(folder / "a.png", bytes);
    return messageOf([&] { readPng(folder / "a.png"); });
  };
  EXPECT_THAT(message(""), HasSubstr("a.png: it is empty"));
  EXPECT_THAT(message("GIF89a, really, and more of it than a header"), HasSubstr("not a PNG"));
  EXPECT_THAT(messageOf([&] { readPng(folder / "none.png"); }), HasSubstr("none.png"));
}

TEST(PngReader, WithoutAlphaAllIsCovered) {
  const std::string grey("\0\x33", 2);  // filter none, 51 / 255
  EXPECT_THAT(read(png(1, 1, 8, 0, stored(grey))).rgba, ElementsAre(0.2F, 0.2F, 0.2F, 1.0F));
  const std::string colors("\0\xff\x00\x33", 4);
  EXPECT_THAT(read(png(1, 1, 8, 2, stored(colors))).rgba, ElementsAre(1.0F, 0.0F, 0.2F, 1.0F));
}

TEST(PngReader, KeepsSixteenBits) {
  const std::string pixel("\0\x80\x01\x00\x01\xff\xff\x40\x00", 9);
  EXPECT_THAT(read(png(1, 1, 16, 6, stored(pixel))).rgba,
              ElementsAre(32769.0F / 65535.0F, 1.0F / 65535.0F, 1.0F, 16384.0F / 65535.0F));
}

TEST(PngReader, NoLengthOfAFileBreaksIt) {
  const std::string whole = png(2, 1, 8, 2, stored(std::string("\0abcdef", 7)));
  const std::size_t pixelsEnd = whole.size() - 12;  // what follows is IEND
  for (std::size_t length = 0; length < pixelsEnd - 4; ++length) {
    EXPECT_THAT(messageOf([&] { read(whole.substr(0, length)); }), HasSubstr("a.png")) << length;
  }
}

TEST(PngReader, AHeaderAloneAllocatesNothing) {
  EXPECT_THAT(messageOf([] { read(png(16384, 16384, 8, 6, stored("x"))); }),
              HasSubstr("more pixels than the file can hold"));
  EXPECT_THAT(messageOf([] { read(png(16385, 1, 8, 6, stored("x"))); }), HasSubstr("16385x1"));
  EXPECT_THAT(messageOf([] { read(png(0, 1, 8, 6, stored("x"))); }), HasSubstr("0x1"));
}

// Fixed Huffman codes (RFC 1951, 3.2.6): a zero, then matches of 258 bytes at distance 1, whose 13
// bits are code 285 (11000101), distance code 0 (00000).
TEST(PngReader, FewBytesThatUnpackToManyAreRefused) {
  std::string bytes = "\x78\x01";
  unsigned buffer = 0;
  unsigned count = 0;
  const auto put = [&](unsigned bit) {
    buffer |= bit << count++;
    if (count < 8) return;
    bytes += static_cast<char>(buffer);
    buffer = count = 0;
  };
  const auto code = [&](unsigned value, int length) {
    for (int bit = length - 1; bit >= 0; --bit) put(value >> static_cast<unsigned>(bit) & 1U);
  };
  for (const unsigned bit : {1U, 1U, 0U}) put(bit);  // the last block, of fixed codes
  code(0b00110000, 8);
  for (int match = 0; match < 100000; ++match) code(0b1100010100000, 13);
  code(0, 7);
  for (int i = 0; i < 8; ++i) put(0);
  EXPECT_THAT(messageOf([&] { read(png(1, 1, 8, 0, bytes + fourZeros)); }), HasSubstr("a.png"));
}

}  // namespace
}  // namespace opaline::core
