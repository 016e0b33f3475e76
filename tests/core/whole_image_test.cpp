#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "core/temporary_folder.h"
#include "opaline/image_file.h"

namespace opaline::core {
namespace {

using test::readBytes;
using test::TemporaryFolder;
using test::writeBytes;

constexpr int width = 37;
constexpr int height = 41;  // EXR has 16 lines per block, so there are three blocks

class WholeImage : public testing::TestWithParam<const char*> {
 protected:
  WholeImage() : file_(folder_ / GetParam()) {
    Image image(width, height);
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
      image.rgba[i] = static_cast<float>(i * i % 101) / 100;
    }
    if (file_.extension() != ".png") {
      writeExr(file_, image);
    } else {
      writePng(file_, {width, height, std::vector<std::uint8_t>(image.rgba.size(), 7)});
    }
    bytes_ = readBytes(file_);
  }

  bool whole() const { return isWholeImage(file_, width, height); }

  TemporaryFolder folder_;
  std::filesystem::path file_;
  std::string bytes_;
};

TEST_P(WholeImage, IsThatOfTheRightSize) {
  EXPECT_TRUE(whole());
  EXPECT_FALSE(isWholeImage(file_, width + 1, height));
  EXPECT_FALSE(isWholeImage(file_, width, height - 1));
  EXPECT_FALSE(isWholeImage(file_, height, width));
}

TEST_P(WholeImage, IsNoneThatLacksAByte) {
  for (std::size_t length = 0; length < bytes_.size(); length += 1 + length / 50) {
    writeBytes(file_, std::string_view(bytes_).substr(0, length));
    EXPECT_FALSE(whole()) << length;
  }
  writeBytes(file_, std::string_view(bytes_).substr(0, bytes_.size() - 1));
  EXPECT_FALSE(whole());
}

TEST_P(WholeImage, IsNoFolderAndNoneThatIsNotThere) {
  std::filesystem::remove(file_);
  EXPECT_FALSE(whole());
  std::filesystem::create_directory(file_);
  EXPECT_FALSE(whole());
}

TEST_P(WholeImage, IsNoNoise) {
  writeBytes(file_, std::string(1000, '\x5a'));
  EXPECT_FALSE(whole());
  for (std::size_t at = 0; at < 400 && at < bytes_.size(); ++at) {
    std::string bytes = bytes_;
    bytes[at] = static_cast<char>(~bytes[at]);
    writeBytes(file_, bytes);
    whole();  // whatever it says, it comes back
  }
}

TEST_P(WholeImage, KeepsANote) {
  EXPECT_EQ(readImageNote(file_), std::nullopt);
  const std::string note = R"({"made by": "hand", "digest": "0123"})";
  if (file_.extension() != ".png") {
    Image image(width, height);
    writeExr(file_, image, note);
  } else {
    writePng(file_, {width, height, std::vector<std::uint8_t>(4 * width * height, 7)}, note);
    EXPECT_NE(readBytes(file_).find("tEXtOpaline" + std::string(1, '\0') + note),
              std::string::npos);
    EXPECT_EQ(readPng(file_).width, width);
  }
  EXPECT_TRUE(whole());
  EXPECT_EQ(readImageNote(file_), note);
  const std::string bytes = readBytes(file_);
  for (std::size_t length = 0; length < bytes.size(); length += 1 + length / 50) {
    writeBytes(file_, std::string_view(bytes).substr(0, length));
    const auto read = readImageNote(file_);
    EXPECT_TRUE(!read || *read == note) << length;
  }
  std::filesystem::remove(file_);
  EXPECT_EQ(readImageNote(file_), std::nullopt);
}

INSTANTIATE_TEST_SUITE_P(Kinds, WholeImage, testing::Values("a.png", "a.exr", "a.EXR"));

}  // namespace
}  // namespace opaline::core
