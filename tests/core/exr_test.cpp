#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfTiledOutputFile.h>
#include <gmock/gmock.h>
#include <half.h>

#include <array>
#include <limits>
#include <vector>

#include "core/temporary_folder.h"
#include "opaline/image_file.h"

namespace opaline::core {
namespace {

namespace fs = std::filesystem;
using test::messageOf;
using test::readBytes;
using test::TemporaryFolder;
using test::writeBytes;
using testing::HasSubstr;

Image gradient(int width, int height) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    image.rgba[i] = static_cast<float>(i % 977) * 0.37F;
  }
  return image;
}

TEST(Exr, RoundTripIsExact) {
  const TemporaryFolder folder;
  Image image = gradient(67, 45);
  image.pixel(3, 4)[0] = 70000.0F;
  image.pixel(3, 4)[1] = 3e38F;
  image.pixel(3, 4)[2] = 1e-40F;
  writeExr(folder / "a.exr", image);
  const Image back = readHdrImage(folder / "a.exr");
  EXPECT_EQ(back.width, 67);
  EXPECT_EQ(back.height, 45);
  EXPECT_EQ(back.rgba, image.rgba);
}

TEST(Exr, SamePixelsGiveTheSameBytes) {
  const TemporaryFolder folder;
  writeExr(folder / "a.exr", gradient(9, 9));
  writeExr(folder / "b.exr", gradient(9, 9));
  EXPECT_EQ(readBytes(folder / "a.exr"), readBytes(folder / "b.exr"));
}

TEST(Exr, NamesTheTargetThatCannotBeWritten) {
  EXPECT_THAT(messageOf([] { writeExr(std::filesystem::path("/dev/full"), gradient(2, 2)); }),
              HasSubstr("/dev/full"));
}

/// Writes the named half channels; channel i of pixel (x, y) is 1000 i + 10 y + x.
void writeHalf(const fs::path& file, const std::vector<const char*>& names, bool tiled,
               Imf::Compression compression) {
  const int width = 37;
  const int height = 21;
  Imf::Header header(width, height);
  header.compression() = compression;
  Imf::FrameBuffer frame;
  std::vector<std::vector<half>> planes;
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::vector<half> plane;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        plane.emplace_back(static_cast<float>(1000 * static_cast<int>(i) + 10 * y + x));
      }
    }
    planes.push_back(std::move(plane));
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    header.channels().insert(names[i], Imf::Channel(Imf::HALF));
    frame.insert(names[i], Imf::Slice(Imf::HALF, reinterpret_cast<char*>(planes[i].data()),
                                      sizeof(half), sizeof(half) * width));
  }
  if (tiled) {
    header.setTileDescription(Imf::TileDescription(16, 8, Imf::ONE_LEVEL));
    Imf::TiledOutputFile output(file.c_str(), header, 0);
    output.setFrameBuffer(frame);
    output.writeTiles(0, output.numXTiles() - 1, 0, output.numYTiles() - 1);
  } else {
    Imf::OutputFile output(file.c_str(), header, 0);
    output.setFrameBuffer(frame);
    output.writePixels(height);
  }
}

void expectPattern(const Image& image, std::array<float, 3> offsets, bool alpha) {
  ASSERT_EQ(image.width, 37);
  ASSERT_EQ(image.height, 21);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const auto base = static_cast<float>(10 * y + x);
      for (std::size_t c = 0; c < 3; ++c) {
        // Halves between 1024 and 2048 are whole numbers, larger ones are even.
        ASSERT_NEAR(image.pixel(x, y)[c], base + offsets[c], 1.0F) << x << ' ' << y << ' ' << c;
      }
      ASSERT_NEAR(image.pixel(x, y)[3], alpha ? base + 3000 : 1.0F, 1.0F);
    }
  }
}

TEST(Exr, ReadsHalvesScanlineAndTiled) {
  const TemporaryFolder folder;
  for (const bool tiled : {false, true}) {
    for (const Imf::Compression compression :
         {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION}) {
      writeHalf(folder / "a.exr", {"R", "G", "B", "A"}, tiled, compression);
      expectPattern(readHdrImage(folder / "a.exr"), {0, 1000, 2000}, true);
    }
  }
}

TEST(Exr, AlphaIsOptionalAndOtherChannelsAreLeftAlone) {
  const TemporaryFolder folder;
  writeHalf(folder / "a.exr", {"R", "G", "B", "depth.Z"}, false, Imf::ZIP_COMPRESSION);
  expectPattern(readHdrImage(folder / "a.exr"), {0, 1000, 2000}, false);
}

TEST(Exr, LuminanceBecomesGrey) {
  const TemporaryFolder folder;
  writeHalf(folder / "a.exr", {"Y"}, false, Imf::ZIP_COMPRESSION);
  expectPattern(readHdrImage(folder / "a.exr"), {0, 0, 0}, false);
}

TEST(Exr, TheFirstOfSeveralPartsIsRead) {
  const TemporaryFolder folder;
  std::vector<float> pixels = {1, 2, 3, 4};
  std::array<Imf::Header, 2> headers = {Imf::Header(2, 2), Imf::Header(2, 2)};
  for (std::size_t i = 0; i < headers.size(); ++i) {
    headers[i].setName(i == 0 ? "first" : "second");
    headers[i].setType(Imf::SCANLINEIMAGE);
    headers[i].channels().insert("Y", Imf::Channel(Imf::FLOAT));
  }
  {
    Imf::MultiPartOutputFile file((folder / "a.exr").c_str(), headers.data(), 2, false, 0);
    Imf::FrameBuffer frame;
    frame.insert("Y", Imf::Slice::Make(Imf::FLOAT, pixels.data(), headers[0].dataWindow()));
    for (int i = 0; i < 2; ++i) {
      Imf::OutputPart part(file, i);
      part.setFrameBuffer(frame);
      part.writePixels(2);
      for (float& value : pixels) value *= 10;
    }
  }
  const Image image = readHdrImage(folder / "a.exr");
  EXPECT_EQ(image.pixel(1, 0)[2], 2.0F);
  EXPECT_EQ(image.pixel(0, 1)[0], 3.0F);
}

TEST(Exr, RefusesOtherChannels) {
  const TemporaryFolder folder;
  writeHalf(folder / "a.exr", {"R", "G"}, false, Imf::ZIP_COMPRESSION);
  EXPECT_THAT(messageOf([&] { readHdrImage(folder / "a.exr"); }),
              testing::AllOf(HasSubstr("a.exr"), HasSubstr("G, R")));
  writeHalf(folder / "a.exr", {"Y", "RY", "BY"}, false, Imf::ZIP_COMPRESSION);
  EXPECT_THAT(messageOf([&] { readHdrImage(folder / "a.exr"); }), HasSubstr("BY, RY, Y"));
}

TEST(Exr, TheLargestHalfSurvives) {
  const TemporaryFolder folder;
  half sun(65504.0F);
  Imf::Header header(1, 1);
  Imf::FrameBuffer frame;
  for (const char* name : {"R", "G", "B"}) {
    header.channels().insert(name, Imf::Channel(Imf::HALF));
    frame.insert(name, Imf::Slice(Imf::HALF, reinterpret_cast<char*>(&sun), 2, 2));
  }
  const fs::path file = folder / "sun.exr";
  const auto write = [&] {
    Imf::OutputFile output(file.c_str(), header, 0);
    output.setFrameBuffer(frame);
    output.writePixels(1);
  };
  write();
  EXPECT_EQ(readHdrImage(file).pixel(0, 0)[1], 65504.0F);
  sun = half(70000.0F);  // overflows to infinity
  write();
  EXPECT_THAT(messageOf([&] { readHdrImage(file); }), HasSubstr("infinite"));
}

TEST(Exr, NegativeBecomesZeroAndNanIsAnError) {
  const TemporaryFolder folder;
  Image image = gradient(4, 4);
  image.pixel(2, 2)[1] = -5.0F;
  writeExr(folder / "a.exr", image);
  EXPECT_EQ(readHdrImage(folder / "a.exr").pixel(2, 2)[1], 0.0F);
  image.pixel(2, 2)[1] = std::numeric_limits<float>::quiet_NaN();
  writeExr(folder / "a.exr", image);
  EXPECT_THROW(readHdrImage(folder / "a.exr"), Error);
}

TEST(Exr, RefusesACroppedDataWindow) {
  const TemporaryFolder folder;
  std::vector<float> pixels(16, 1.0F);
  const Imath::Box2i data(Imath::V2i(2, 2), Imath::V2i(5, 5));
  Imf::Header header(Imath::Box2i(Imath::V2i(0, 0), Imath::V2i(7, 7)), data);
  header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
  Imf::FrameBuffer frame;
  frame.insert("Y", Imf::Slice::Make(Imf::FLOAT, pixels.data(), data));
  {
    Imf::OutputFile output((folder / "a.exr").c_str(), header, 0);
    output.setFrameBuffer(frame);
    output.writePixels(4);
  }
  EXPECT_THAT(messageOf([&] { readHdrImage(folder / "a.exr"); }), HasSubstr("window"));
}

TEST(Exr, EveryTruncationIsAnError) {
  const TemporaryFolder folder;
  writeExr(folder / "a.exr", gradient(16, 20));
  const std::string whole = readBytes(folder / "a.exr");
  for (std::size_t length = 0; length < whole.size(); ++length) {
    writeBytes(folder / "b.exr", std::string_view(whole).substr(0, length));
    EXPECT_THAT(messageOf([&] { readHdrImage(folder / "b.exr"); }), HasSubstr("b.exr")) << length;
  }
}

// A changed byte may have any effect except a crash, a hang or another exception.
TEST(Exr, ChangedBytesAreReadOrRefused) {
  const TemporaryFolder folder;
  for (const bool tiled : {false, true}) {
    writeHalf(folder / "a.exr", {"R", "G", "B", "A"}, tiled, Imf::ZIP_COMPRESSION);
    const std::string whole = readBytes(folder / "a.exr");
    const std::size_t headerBytes = 400;
    for (std::size_t i = 0; i < std::min(whole.size(), headerBytes); ++i) {
      for (const char value : {'\x00', '\x7f', '\xff'}) {
        std::string changed = whole;
        changed[i] = value;
        writeBytes(folder / "b.exr", changed);
        try {
          const Image image = readHdrImage(folder / "b.exr");
          EXPECT_LE(image.rgba.size(), 4U * 37 * 21 * 256);
        } catch (const Error& error) {
          EXPECT_THAT(error.what(), HasSubstr("b.exr"));
        }
      }
    }
  }
}

TEST(Exr, AListOfChannelsWithoutAnEndIsAnError) {
  const TemporaryFolder folder;
  writeHalf(folder / "a.exr", {"Y"}, false, Imf::NO_COMPRESSION);
  std::string changed = readBytes(folder / "a.exr");
  const std::string channel("channels\0chlist\0\x13\0\0\0Y", 21);
  const std::size_t at = changed.find(channel);
  ASSERT_NE(at, std::string::npos);
  changed[at + channel.size() + 17] = 'x';
  writeBytes(folder / "b.exr", changed);
  EXPECT_THAT(messageOf([&] { readHdrImage(folder / "b.exr"); }), HasSubstr("damaged"));
}

TEST(Exr, AnAttributeLongerThanItsTypeIsAnError) {
  const TemporaryFolder folder;
  writeExr(folder / "a.exr", gradient(4, 4));
  std::string changed = readBytes(folder / "a.exr");
  const std::string window("displayWindow\0box2i\0", 20);
  const std::size_t at = changed.find(window);
  ASSERT_NE(at, std::string::npos);
  changed[at + window.size()] = 17;
  changed.insert(at + window.size() + 4, 1, '\0');
  writeBytes(folder / "b.exr", changed);
  EXPECT_THAT(messageOf([&] { readHdrImage(folder / "b.exr"); }), HasSubstr("damaged"));
}

TEST(Exr, AHugeClaimIsAnError) {
  const TemporaryFolder folder;
  writeExr(folder / "a.exr", gradient(16, 16));
  const std::string whole = readBytes(folder / "a.exr");
  const std::string name("dataWindow\0box2i\0\x10\0\0\0", 21);
  const std::size_t at = whole.find(name);
  ASSERT_NE(at, std::string::npos);
  for (const std::string& far :
       {std::string("\xff\x3f\0\0", 4), std::string("\0\x40\0\0", 4),
        std::string("\xff\xff\xff\x3f", 4), std::string("\xff\xff\xff\x7f", 4)}) {
    std::string changed = whole;
    changed.replace(at + name.size() + 8, 8, far + far);
    writeBytes(folder / "b.exr", changed);
    EXPECT_THAT(messageOf([&] { readHdrImage(folder / "b.exr"); }), HasSubstr("b.exr"));
  }
}

}  // namespace
}  // namespace opaline::core
