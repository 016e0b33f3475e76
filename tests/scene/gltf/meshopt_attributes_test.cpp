// The attribute codec of EXT_meshopt_compression and KHR_meshopt_compression. Streams are made by
// meshoptimizer, or by hand from the specification where it cannot make them.

#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <random>
#include <vector>

#include "scene/gltf/meshopt_attributes.h"
#include "scene/gltf/meshopt_streams.h"

namespace opaline {
namespace {

using test::Bytes;
using test::encodedAttributes;

/// Steps of many sizes between elements, as in real attributes and in noise.
Bytes walk(std::size_t count, std::size_t stride, std::mt19937& random) {
  Bytes bytes(count * stride);
  for (std::size_t k = 0; k < stride; ++k) {
    const unsigned reach = 1U << random() % 9;
    auto value = static_cast<unsigned>(random());
    for (std::size_t i = 0; i < count; ++i) {
      if (random() % 40 == 0) value = static_cast<unsigned>(random());
      value += static_cast<unsigned>(random()) % reach;
      bytes[i * stride + k] = static_cast<unsigned char>(value);
    }
  }
  return bytes;
}

TEST(MeshoptAttributes, DecodeWhatTheLibraryEncodes) {
  std::mt19937 random(1);
  for (const std::size_t stride : {4U, 8U, 12U, 16U, 28U, 64U, 252U, 256U}) {
    for (const std::size_t count : {0U, 1U, 15U, 16U, 17U, 31U, 64U, 255U, 256U, 257U, 1000U}) {
      const Bytes elements = walk(count, stride, random);
      const Bytes stream = encodedAttributes(elements, stride);
      Bytes decoded(elements.size());
      ASSERT_TRUE(scene::decodeMeshoptAttributes(stream, stride, decoded))
          << stride << " " << count;
      ASSERT_EQ(decoded, elements) << stride << " " << count;
    }
  }
}

TEST(MeshoptAttributes, StreamsThatAreTooShortOrTooLongAreDamaged) {
  std::mt19937 random(2);
  const Bytes elements = walk(300, 8, random);
  const Bytes stream = encodedAttributes(elements, 8);
  Bytes decoded(elements.size());
  for (std::size_t size = 0; size < stream.size(); ++size) {
    const Bytes cut(stream.begin(), stream.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_FALSE(scene::decodeMeshoptAttributes(cut, 8, decoded)) << size;
  }
  Bytes longer = stream;
  longer.insert(longer.begin() + 1, 1, static_cast<unsigned char>(0));
  EXPECT_FALSE(scene::decodeMeshoptAttributes(longer, 8, decoded));
  for (const unsigned char header : Bytes{0x00, 0x9f, 0xa2, 0xe1, 0xff}) {
    Bytes other = stream;
    other[0] = header;
    EXPECT_FALSE(scene::decodeMeshoptAttributes(other, 8, decoded)) << unsigned{header};
  }
}

TEST(MeshoptAttributes, NoiseIsDecodedOrRefused) {
  std::mt19937 random(4);
  int decodable = 0;
  for (int i = 0; i < 20000; ++i) {
    const std::size_t stride = 4 + 4 * (random() % 4);
    Bytes stream(33 + random() % 200);
    for (unsigned char& byte : stream) byte = static_cast<unsigned char>(random());
    stream[0] = static_cast<unsigned char>(0xa0 + random() % 2);
    std::fill(stream.end() - static_cast<std::ptrdiff_t>(stride / 4), stream.end(),
              static_cast<unsigned char>(random() % 3));
    Bytes decoded(stride * (1 + random() % 40));
    decodable += scene::decodeMeshoptAttributes(stream, stride, decoded) ? 1 : 0;
  }
  EXPECT_GT(decodable, 0);
}

/// A stream of version 1: header, blocks, tail.
Bytes version1(const Bytes& blocks, const Bytes& baseline, const Bytes& modes) {
  Bytes stream{0xa1};
  stream.insert(stream.end(), blocks.begin(), blocks.end());
  const std::size_t tail = baseline.size() + modes.size();
  stream.resize(stream.size() + (tail < 24 ? 24 - tail : 0));
  stream.insert(stream.end(), baseline.begin(), baseline.end());
  stream.insert(stream.end(), modes.begin(), modes.end());
  return stream;
}

// KHR_meshopt_compression, appendix A: the example of 16 deltas is from there.
TEST(MeshoptAttributes, ControlsOfVersion1) {
  const Bytes example{0x17, 0x5f, 0xf0, 0xbc, 0x77, 0xa9, 0x21, 0x00, 0x34, 0xb5};
  const std::vector<int> deltas{-1, -4, -3, 26, -91, 0, -6, 6, -4, -4, 5, -5, 1, -1, 0, 0};
  // Byte 0 has control 0 and four bits by header 3; byte 1 has control 1 and four bits by header 2;
  // byte 2 is all zero; byte 3 is literal.
  Bytes block{0b11'10'01'00};
  block.push_back(3);
  block.insert(block.end(), example.begin(), example.end());
  block.push_back(2);
  block.insert(block.end(), example.begin(), example.end());
  for (unsigned char i = 0; i < 16; ++i) block.push_back(static_cast<unsigned char>(2 * i));
  const Bytes stream = version1(block, {10, 20, 30, 40}, {0});
  Bytes decoded(64);
  ASSERT_TRUE(scene::decodeMeshoptAttributes(stream, 4, decoded));
  int sum = 0;
  int literals = 0;
  for (std::size_t i = 0; i < 16; ++i) {
    sum += deltas[i];
    literals += static_cast<int>(i);  // zigzag: 2 i means i
    EXPECT_EQ(decoded[4 * i], static_cast<unsigned char>(10 + sum)) << i;
    EXPECT_EQ(decoded[4 * i + 1], static_cast<unsigned char>(20 + sum)) << i;
    EXPECT_EQ(decoded[4 * i + 2], 30) << i;
    EXPECT_EQ(decoded[4 * i + 3], static_cast<unsigned char>(40 + literals)) << i;
  }
}

TEST(MeshoptAttributes, SingleBitsOfVersion1) {
  // Control 0, header 1: a byte follows for each set bit, from the lowest.
  const Bytes block{0b10'10'10'00, 1, 0b0000'0101, 0b1000'0000, 8, 3, 0x80};
  const Bytes stream = version1(block, {0, 0, 0, 0}, {0});
  Bytes decoded(64);
  ASSERT_TRUE(scene::decodeMeshoptAttributes(stream, 4, decoded));
  EXPECT_EQ(decoded[0], 4);            // +4
  EXPECT_EQ(decoded[4], 4);            // unchanged
  EXPECT_EQ(decoded[8], 2);            // −2
  EXPECT_EQ(decoded[4 * 14], 2);       // unchanged
  EXPECT_EQ(decoded[4 * 15], 2 + 64);  // +64
}

/// Literal deltas, by the specification's formulas for encoders.
TEST(MeshoptAttributes, ChannelsOfVersion1) {
  std::mt19937 random(3);
  constexpr std::size_t count = 21;
  constexpr int turned = 5;
  const Bytes elements = walk(count + 1, 8, random);  // the first is the baseline
  const auto at = [&](std::size_t element, std::size_t byte, std::size_t bytes) {
    std::uint32_t value = 0;
    std::memcpy(&value, &elements[element * 8 + byte], bytes);
    return value;
  };
  Bytes block{0xff, 0xff};
  const auto literal = [&](auto&& deltaOf, std::size_t byte) {
    for (std::size_t i = 1; i <= count; ++i) {
      block.push_back(static_cast<unsigned char>(deltaOf(i) >> (8 * byte)));
    }
  };
  for (std::size_t pair = 0; pair < 4; pair += 2) {
    const auto zigzag = [&](std::size_t i) {
      const auto v = static_cast<std::uint16_t>(at(i, pair, 2) - at(i - 1, pair, 2));
      return (v & 0x8000U) != 0 ? static_cast<std::uint16_t>(~(unsigned{v} << 1U))
                                : static_cast<std::uint16_t>(unsigned{v} << 1U);
    };
    literal(zigzag, 0);
    literal(zigzag, 1);
  }
  for (std::size_t byte = 0; byte < 4; ++byte) {
    literal([&](std::size_t i) { return std::rotl(at(i, 4, 4) ^ at(i - 1, 4, 4), turned); }, byte);
  }
  const Bytes baseline(elements.begin(), elements.begin() + 8);
  Bytes decoded(count * 8);
  ASSERT_TRUE(
      scene::decodeMeshoptAttributes(version1(block, baseline, {1, 2 | turned << 4}), 8, decoded));
  EXPECT_EQ(decoded, Bytes(elements.begin() + 8, elements.end()));
  for (const unsigned char mode : Bytes{3, 4, 0x10, 0x11}) {
    EXPECT_FALSE(scene::decodeMeshoptAttributes(version1(block, baseline, {1, mode}), 8, decoded));
  }
}

}  // namespace
}  // namespace opaline
