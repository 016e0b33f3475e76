#include <gmock/gmock.h>
#include <stb_image.h>

#include <memory>

#include "core/temporary_folder.h"
#include "opaline/image_file.h"

namespace opaline::core {
namespace {

using test::messageOf;
using test::readBytes;
using test::TemporaryFolder;

Image8 pattern(int width, int height) {
  Image8 image{width, height, {}};
  for (int i = 0; i < width * height * 4; ++i) {
    image.rgba.push_back(static_cast<std::uint8_t>(i * 37 + i / 256));
  }
  return image;
}

TEST(Png, RoundTrip) {
  const TemporaryFolder folder;
  const Image8 image = pattern(31, 17);
  writePng(folder / "a.png", image);

  const std::string bytes = readBytes(folder / "a.png");
  int width = 0;
  int height = 0;
  int channels = 0;
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                            static_cast<int>(bytes.size()), &width, &height, &channels, 0),
      stbi_image_free);
  ASSERT_TRUE(pixels);
  ASSERT_EQ(width, 31);
  ASSERT_EQ(height, 17);
  ASSERT_EQ(channels, 4);
  EXPECT_EQ(std::vector<std::uint8_t>(pixels.get(), pixels.get() + image.rgba.size()), image.rgba);
}

TEST(Png, SamePixelsGiveTheSameBytes) {
  const TemporaryFolder folder;
  writePng(folder / "a.png", pattern(8, 8));
  writePng(folder / "b.png", pattern(8, 8));
  EXPECT_EQ(readBytes(folder / "a.png"), readBytes(folder / "b.png"));
}

TEST(Png, NamesTheTargetThatCannotBeWritten) {
  EXPECT_THAT(messageOf([] { writePng(std::filesystem::path("/dev/full"), pattern(2, 2)); }),
              testing::HasSubstr("/dev/full"));
}

}  // namespace
}  // namespace opaline::core
