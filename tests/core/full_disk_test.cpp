// A disk that fills up after any number of bytes: the existing file stays, and nothing else is
// left.

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>
#include <functional>
#include <string>

#include "core/temporary_folder.h"
#include "opaline/file.h"
#include "opaline/image_file.h"

namespace opaline::core {
namespace {

using test::readBytes;
using test::TemporaryFolder;
using test::writeBytes;

/// Limits this process's files to so many bytes, as on a full disk.
class FullDisk {
 public:
  explicit FullDisk(std::size_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() { setrlimit(RLIMIT_FSIZE, &before_); }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
};

using Write = std::function<void(const std::filesystem::path&)>;

/// The message of writing with room for so many bytes; empty on success.
std::string said(const Write& write, const std::filesystem::path& file, std::size_t bytes) {
  const FullDisk full(bytes);
  try {
    write(file);
    return {};
  } catch (const Error& error) {
    return error.what();
  }
}

void fillAfterEveryByte(const std::string& name, const Write& write) {
  const auto before = std::signal(SIGXFSZ, SIG_IGN);
  const TemporaryFolder folder;
  write(folder / name);
  const std::string whole = readBytes(folder / name);
  ASSERT_GT(whole.size(), 100U);
  writeBytes(folder / name, "older");
  for (std::size_t bytes = 0; bytes < whole.size() && !testing::Test::HasFailure(); ++bytes) {
    const std::string sentence = said(write, folder / name, bytes);
    EXPECT_THAT(sentence, testing::HasSubstr(name)) << "after " << bytes << " bytes";
    EXPECT_THAT(sentence, testing::Not(testing::HasSubstr("\n")));
    EXPECT_EQ(readBytes(folder / name), "older");
    EXPECT_EQ(folder.fileCount(), 1U) << "after " << bytes << " bytes";
  }
  EXPECT_EQ(said(write, folder / name, whole.size()), "");
  EXPECT_EQ(readBytes(folder / name), whole);
  std::signal(SIGXFSZ, before);
}

TEST(FullDiskAfterEveryByte, Png) {
  fillAfterEveryByte("a.png", [](const std::filesystem::path& file) {
    Image8 image{8, 8, {}};
    for (int i = 0; i < 256; ++i) image.rgba.push_back(static_cast<std::uint8_t>(i * 37));
    writePng(file, image, "a note");
  });
}

TEST(FullDiskAfterEveryByte, Exr) {
  fillAfterEveryByte("a.exr", [](const std::filesystem::path& file) {
    Image image(6, 5);
    for (std::size_t i = 0; i < image.rgba.size(); ++i)
      image.rgba[i] = 1.0F / static_cast<float>(i + 1);
    writeExr(file, image, "a note");
  });
}

TEST(FullDiskAfterEveryByte, Text) {
  fillAfterEveryByte(
      "a.toml", [](const std::filesystem::path& file) { writeWhole(file, std::string(500, 'a')); });
}

}  // namespace
}  // namespace opaline::core
