#include <fmt/format.h>
#include <gmock/gmock.h>

#include "core/temporary_folder.h"
#include "opaline/image_file.h"

namespace opaline::core {
namespace {

using test::messageOf;
using test::TemporaryFolder;
using test::writeBytes;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string head = "#?RADIANCE\n# a comment\nFORMAT=32-bit_rle_rgbe\n\n";

std::string resolution(int width, int height) {
  return "-Y " + std::to_string(height) + " +X " + std::to_string(width) + "\n";
}

Image readRadiance(const std::string& bytes) {
  const TemporaryFolder folder;
  writeBytes(folder / "sky.hdr", bytes);
  return readHdrImage(folder / "sky.hdr");
}

// RGBE: mantissa · 2^(exponent - 136). 128 · 2^-7 = 1; 137 · 2^9 = 70144, a sun.
TEST(Radiance, PlainPixels) {
  const Image image =
      readRadiance(head + resolution(2, 2) + "\x80\x40\x20\x81" + "\x89\x89\x89\x91" +
                   std::string("\xff\xff\xff\x00", 4) + std::string("\x01\x00\x00\x01", 4));
  ASSERT_EQ(image.width, 2);
  ASSERT_EQ(image.height, 2);
  EXPECT_THAT(std::vector<float>(image.rgba.begin(), image.rgba.begin() + 12),
              ElementsAre(1.0F, 0.5F, 0.25F, 1.0F, 70144.0F, 70144.0F, 70144.0F, 1.0F, 0.0F, 0.0F,
                          0.0F, 1.0F));
  EXPECT_FLOAT_EQ(image.pixel(1, 1)[0], 0x1p-135F);
}

std::string runLengthRow(int width) {
  const auto byte = [](int value) { return static_cast<char>(static_cast<unsigned char>(value)); };
  std::string row = {2, 2, byte(width / 256), byte(width % 256)};
  for (int channel = 0; channel < 4; ++channel) {
    const int value = channel == 3 ? 129 : 32 << channel;
    int left = width;
    row += byte(2);  // two literal bytes, then runs
    row += byte(value);
    row += byte(value);
    for (left -= 2; left > 0;) {
      const int run = left > 127 ? 127 : left;
      row += byte(128 + run);
      row += byte(value);
      left -= run;
    }
  }
  return row;
}

TEST(Radiance, RunLengthRows) {
  const int width = 300;
  const Image image =
      readRadiance(head + resolution(width, 2) + runLengthRow(width) + runLengthRow(width));
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < width; ++x) {
      EXPECT_EQ(image.pixel(x, y)[0], 0.25F);
      EXPECT_EQ(image.pixel(x, y)[1], 0.5F);
      EXPECT_EQ(image.pixel(x, y)[2], 1.0F);
      EXPECT_EQ(image.pixel(x, y)[3], 1.0F);
    }
  }
}

TEST(Radiance, OldRepeats) {
  // One pixel, 3 repeats, then 256 more by a second count.
  const Image image = readRadiance(head + resolution(260, 1) + "\x80\x80\x80\x81" +
                                   "\x01\x01\x01\x03" + "\x01\x01\x01\x01");
  for (int x = 0; x < 260; ++x) EXPECT_EQ(image.pixel(x, 0)[1], 1.0F);
}

TEST(Radiance, ExposureIsTakenOut) {
  const Image image =
      readRadiance("#?RGBE\nEXPOSURE=2\nEXPOSURE= 0.25\nFORMAT=32-bit_rle_rgbe\n\n" +
                   resolution(1, 1) + "\x80\x80\x80\x81");
  EXPECT_EQ(image.pixel(0, 0)[0], 2.0F);
}

TEST(Radiance, EveryTruncationIsAnError) {
  const TemporaryFolder folder;
  const std::string whole = head + resolution(20, 2) + runLengthRow(20) + runLengthRow(20);
  EXPECT_NO_THROW(readRadiance(whole));
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_THROW(readRadiance(whole.substr(0, length)), Error) << length;
  }
}

TEST(Radiance, HostileResolutionsAreErrors) {
  for (const char* line :
       {"-Y 16384 +X 16384", "-Y 16385 +X 1", "-Y 2147483648 +X 1", "-Y 99999999999999999999 +X 1",
        "-Y 0 +X 1", "-Y -1 +X 1", "+Y 1 +X 1", "-Y 1 +X 1 ", ""}) {
    const std::string bytes = fmt::format("{}{}\n\x80\x80\x80\x81", head, line);
    EXPECT_THAT(messageOf([&] { readRadiance(bytes); }), HasSubstr("sky.hdr")) << line;
  }
}

TEST(Radiance, HostileHeadersAreErrors) {
  const std::string endless(10000, 'x');
  for (const std::string& line :
       {std::string("FORMAT=32-bit_rle_xyze"), std::string("EXPOSURE=0"), std::string("EXPOSURE=x"),
        std::string("EXPOSURE=1e-300"), endless}) {
    const std::string bytes = fmt::format("#?RADIANCE\n{}\n\n-Y 1 +X 1\n\x80\x80\x80\x81", line);
    EXPECT_THAT(messageOf([&] { readRadiance(bytes); }), HasSubstr("sky.hdr"))
        << line.substr(0, 80);
  }
}

TEST(Radiance, HostileRunsAreErrors) {
  const std::string intro = head + resolution(8, 1);
  for (const std::string_view row :
       {std::string_view("\x02\x02\x00\x09\x88\x01", 6),          // another width
        std::string_view("\x02\x02\x00\x08\x89\x01", 6),          // a run past the end
        std::string_view("\x02\x02\x00\x08\x00\x00\x00\x00", 8),  // no pixels at all
        std::string_view("\x01\x01\x01\x02", 4),                  // repeats nothing
        std::string_view("\x80\x80\x80\x81\x01\x01\x01\x08", 8)}) {
    const std::string bytes = fmt::format("{}{}", intro, row);
    EXPECT_THAT(messageOf([&] { readRadiance(bytes); }), HasSubstr("sky.hdr"));
  }
}

TEST(Radiance, OtherFilesAreErrors) {
  const TemporaryFolder folder;
  EXPECT_THAT(messageOf([] { readRadiance(""); }), HasSubstr("empty"));
  EXPECT_THAT(messageOf([] { readRadiance("\x89PNG\r\n\x1a\n"); }), HasSubstr("neither"));
  EXPECT_THAT(messageOf([&] { readHdrImage(folder.path()); }), HasSubstr("folder"));
  EXPECT_THAT(messageOf([&] { readHdrImage(folder / "none.hdr"); }), HasSubstr("none.hdr"));
}

}  // namespace
}  // namespace opaline::core
