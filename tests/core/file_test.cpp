#include "opaline/file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
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

TEST(ReadFile, GivesTheBytes) {
  const TemporaryFolder folder;
  writeBytes(folder / "a.bin", std::string_view("a\0b\xff", 4));
  const std::vector<std::byte> bytes = readFile(folder / "a.bin", 4);
  EXPECT_THAT(bytes,
              testing::ElementsAre(std::byte{'a'}, std::byte{0}, std::byte{'b'}, std::byte{0xff}));
  EXPECT_THAT(readFileHead(folder / "a.bin", 1), testing::ElementsAre(std::byte{'a'}));
  EXPECT_EQ(readFileHead(folder / "a.bin", 100).size(), 4U);
}

TEST(ReadFile, GivesNothingForAnEmptyFile) {
  const TemporaryFolder folder;
  writeBytes(folder / "empty", "");
  EXPECT_TRUE(readFile(folder / "empty", 10).empty());
}

TEST(ReadFile, RefusesWhatIsTooLong) {
  const TemporaryFolder folder;
  writeBytes(folder / "long.bin", "12345");
  EXPECT_THAT(messageOf([&] { readFile(folder / "long.bin", 4); }),
              testing::AllOf(HasSubstr("long.bin"), HasSubstr("5"), HasSubstr("4")));
}

TEST(ReadFile, RefusesWhatIsNoFile) {
  const TemporaryFolder folder;
  EXPECT_THAT(messageOf([&] { readFile(folder / "none", 4); }), HasSubstr("no such file"));
  EXPECT_THAT(messageOf([&] { readFile(folder.path(), 4); }), HasSubstr("folder"));
  EXPECT_THAT(messageOf([&] { readFile("/dev/zero", 4); }), HasSubstr("not a regular file"));
  EXPECT_THAT(messageOf([&] { readFile("", 4); }), HasSubstr("without a name"));
}

TEST(WriteWhole, ReplacesAndLeavesNothingElse) {
  const TemporaryFolder folder;
  writeWhole(folder / "a.txt", "old and longer");
  writeWhole(folder / "a.txt", "new");
  EXPECT_EQ(readBytes(folder / "a.txt"), "new");
  EXPECT_EQ(folder.fileCount(), 1U);
}

TEST(WriteWhole, TakesTheNextFreeName) {
  const TemporaryFolder folder;
  const Target target(folder / "a.b.txt", Existing::TakeNextName);
  EXPECT_EQ(writeWhole(target, "first"), folder / "a.b.txt");
  EXPECT_EQ(writeWhole(target, "second"), folder / "a.b-2.txt");
  std::filesystem::create_directory(folder / "a.b-3.txt");
  std::filesystem::create_symlink("nowhere", folder / "a.b-4.txt");
  EXPECT_EQ(writeWhole(target, "third"), folder / "a.b-5.txt");
  std::filesystem::remove(folder / "a.b-2.txt");
  EXPECT_EQ(writeWhole(target, "fourth"), folder / "a.b-2.txt");
  EXPECT_EQ(readBytes(folder / "a.b.txt"), "first");
  EXPECT_EQ(readBytes(folder / "a.b-5.txt"), "third");
  EXPECT_EQ(folder.fileCount(), 5U);
}

TEST(WriteWhole, RefusesWhatMustStay) {
  const TemporaryFolder folder;
  const Target target(folder / "a.txt", Existing::Refuse);
  WholeFile late(target);  // begun before any file exists
  writeBytes(late.temporary(), "late");
  writeWhole(target, "first");
  EXPECT_THAT(messageOf([&] { WholeFile again(target); }), HasSubstr("there already"));
  EXPECT_THAT(messageOf([&] { requireWritable(target); }), HasSubstr("there already"));
  EXPECT_THAT(messageOf([&] { late.keep(); }), HasSubstr("there already"));
  EXPECT_EQ(readBytes(folder / "a.txt"), "first");
}

TEST(WriteWhole, RefusesAnUnknownWayToTreatAnExistingFile) {
  const TemporaryFolder folder;
  EXPECT_THAT(messageOf([&] {
                writeWhole({folder / "a.txt", static_cast<Existing>(3)}, "text");
              }),
              HasSubstr("a.txt"));
  EXPECT_EQ(folder.fileCount(), 0U);
}

// Two threads imitate programs that write at once.
TEST(WriteWhole, NobodyReplacesWhatAnotherWroteAtTheSameTime) {
  const TemporaryFolder folder;
  constexpr int writers = 8;
  constexpr int files = 25;
  std::vector<std::thread> threads;
  for (int writer = 0; writer < writers; ++writer) {
    threads.emplace_back([&folder, writer] {
      for (int i = 0; i < files; ++i) {
        writeWhole({folder / "a.txt", Existing::TakeNextName}, std::to_string(files * writer + i));
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  std::set<std::string> contents;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    contents.insert(readBytes(entry.path()));
  }
  EXPECT_EQ(contents.size(), std::size_t{writers * files});
}

// The process's own locks by another descriptor look like those of another process.
TEST(WriteWhole, ClearsWhatKilledProgramsLeftAndNothingElse) {
  const TemporaryFolder folder;
  for (const char* name : {".opaline-1-0.png", ".opaline-23-456", ".opaline-1-2.mp4", ".opaline-x",
                           ".opaline-1-2x", ".opaline-1-.png", ".other-1-2.png"})
    writeBytes(folder / name, "");
  const int held = open((folder / ".opaline-1-2.mp4").c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_EQ(flock(held, LOCK_EX), 0);
  writeWhole(folder / "a.txt", "a");
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder.path()))
    names.insert(entry.path().filename().string());
  EXPECT_THAT(names, testing::ElementsAre(".opaline-1-.png", ".opaline-1-2.mp4", ".opaline-1-2x",
                                          ".opaline-x", ".other-1-2.png", "a.txt"));
  close(held);
}

TEST(WholeFile, IsNotTakenForOneThatWasLeft) {
  const TemporaryFolder folder;
  const WholeFile file(Target(folder / "a.txt"));
  const int other = open(file.temporary().c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_GE(other, 0);
  EXPECT_NE(flock(other, LOCK_EX | LOCK_NB), 0);
  close(other);
}

TEST(WholeFile, TakesItsPlaceOnlyWhenItIsKept) {
  const TemporaryFolder folder;
  writeBytes(folder / "a.mp4", "old");
  {
    const WholeFile file(folder / "a.mp4");
    writeBytes(file.temporary(), "new");
    EXPECT_EQ(readBytes(folder / "a.mp4"), "old");
  }
  EXPECT_EQ(readBytes(folder / "a.mp4"), "old");
  EXPECT_EQ(folder.fileCount(), 1U);
  {
    WholeFile file(folder / "a.mp4");
    writeBytes(file.temporary(), "new");
    file.keep();
    EXPECT_EQ(readBytes(folder / "a.mp4"), "new");
    EXPECT_THAT(messageOf([&] { file.fail("the encoder died"); }),
                testing::AllOf(HasSubstr("a.mp4"), HasSubstr("the encoder died")));
  }
  EXPECT_EQ(readBytes(folder / "a.mp4"), "new");
  EXPECT_EQ(folder.fileCount(), 1U);
  EXPECT_THAT(messageOf([&] { const WholeFile file(folder / "none/a"); }), HasSubstr("folder"));
}

TEST(WriteWhole, KeepsTheExtensionOfTheTemporaryName) {
  const TemporaryFolder folder;
  fs::path seen;
  writeWhole(folder / "film.mp4", [&](const fs::path& temporary) {
    seen = temporary;
    writeBytes(temporary, "x");
  });
  EXPECT_EQ(seen.extension(), ".mp4");
  EXPECT_EQ(seen.parent_path(), folder.path());
}

TEST(WriteWhole, KeepsTheOldFileWhenTheWriterFails) {
  const TemporaryFolder folder;
  writeWhole(folder / "a.txt", "old");
  const std::string message = messageOf([&] {
    writeWhole(folder / "a.txt", [](const fs::path& temporary) {
      writeBytes(temporary, "half");
      throw std::runtime_error("the encoder died");
    });
  });
  EXPECT_THAT(message, testing::AllOf(HasSubstr("a.txt"), HasSubstr("the encoder died")));
  EXPECT_EQ(readBytes(folder / "a.txt"), "old");
  EXPECT_EQ(folder.fileCount(), 1U);
}

TEST(WriteWhole, FailsWhenTheWriterLeavesNoFile) {
  const TemporaryFolder folder;
  EXPECT_THAT(messageOf([&] {
                writeWhole(folder / "a.txt", [](const fs::path& file) { fs::remove(file); });
              }),
              HasSubstr("a.txt"));
  EXPECT_EQ(folder.fileCount(), 0U);
}

TEST(WriteWhole, WritesThroughASymbolicLink) {
  const TemporaryFolder folder;
  writeWhole(folder / "real.txt", "old");
  fs::create_symlink("real.txt", folder / "link.txt");
  writeWhole(folder / "link.txt", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));
  EXPECT_EQ(readBytes(folder / "real.txt"), "new");
}

TEST(WriteWhole, KeepsPermissions) {
  const TemporaryFolder folder;
  writeWhole(folder / "a.txt", "old");
  fs::permissions(folder / "a.txt", fs::perms::owner_read | fs::perms::owner_write);
  writeWhole(folder / "a.txt", "new");
  EXPECT_EQ(fs::status(folder / "a.txt").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

class Unwritable : public testing::TestWithParam<const char*> {};

TEST_P(Unwritable, IsRefusedBeforeAndWhileWriting) {
  const TemporaryFolder folder;
  writeBytes(folder / "file", "x");
  fs::create_symlink("nowhere", folder / "dangling");
  const fs::path target = folder / GetParam();
  const std::size_t filesBefore = folder.fileCount();
  EXPECT_THROW(requireWritable(target), Error);
  EXPECT_THROW(writeWhole(target, "x"), Error);
  EXPECT_EQ(folder.fileCount(), filesBefore);
}

// An absolute path replaces the folder it is appended to.
INSTANTIATE_TEST_SUITE_P(Targets, Unwritable,
                         testing::Values("none/a.png", "file/a.png", "sub/", ".", "/dev/full",
                                         "/dev/null", "dangling", "/proc/a.png", "/"));

TEST(WriteWhole, RefusesTheEmptyName) {
  EXPECT_THROW(writeWhole(std::filesystem::path(), "x"), Error);
  EXPECT_THROW(requireWritable(std::filesystem::path()), Error);
}

TEST(WriteWhole, RefusesANameThatIsTooLong) {
  const TemporaryFolder folder;
  EXPECT_THROW(writeWhole(folder / std::string(300, 'a'), "x"), Error);
  EXPECT_EQ(folder.fileCount(), 0U);
}

/// Imitates a full disk: no file may grow past a limit.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : oldHandler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit limit{bytes, old_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, oldHandler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit old_{};
  void (*oldHandler_)(int);
};

TEST(FullDisk, IsAnErrorAndLeavesNothing) {
  const TemporaryFolder folder;
  Image image(64, 64);
  std::mt19937 random(1);
  for (float& value : image.rgba) value = static_cast<float>(random());
  Image8 pixels{64, 64, std::vector<std::uint8_t>(std::size_t{64} * 64 * 4)};
  for (std::uint8_t& value : pixels.rgba) value = static_cast<std::uint8_t>(random());
  // The last byte may be the one that does not fit, as well as the first.
  writeExr(folder / "a.exr", image);
  const rlim_t exrBytes = fs::file_size(folder / "a.exr");
  fs::remove(folder / "a.exr");
  for (const rlim_t limit : {rlim_t{0}, rlim_t{2000}, exrBytes - 1}) {
    const FileSizeLimit full(limit);
    EXPECT_THAT(messageOf([&] { writeExr(folder / "a.exr", image); }), HasSubstr("a.exr"));
  }
  const FileSizeLimit full(1000);
  EXPECT_THAT(messageOf([&] { writePng(folder / "a.png", pixels); }), HasSubstr("a.png"));
  EXPECT_THAT(messageOf([&] { writeWhole(folder / "a.txt", std::string(100000, 'x')); }),
              HasSubstr("a.txt"));
  EXPECT_EQ(folder.fileCount(), 0U);
}

TEST(AbandonTemporaryFiles, RemovesThemAndEndsTheWriting) {
  const TemporaryFolder folder;
  const fs::path folderPath = folder.path();
  writeBytes(folder / "old.txt", "old");
  EXPECT_EXIT(
      {
        writeWhole(folderPath / "old.txt", [&](const fs::path& temporary) {
          writeBytes(temporary, "half");
          writeWhole(folderPath / "other.txt", "whole");
          writeWhole(folderPath / "third.txt", [](const fs::path&) {
            abandonTemporaryFiles();
            std::_Exit(7);
          });
        });
      },
      testing::ExitedWithCode(7), "");
  EXPECT_EQ(readBytes(folder / "old.txt"), "old");
  EXPECT_EQ(readBytes(folder / "other.txt"), "whole");
  EXPECT_EQ(folder.fileCount(), 2U);
}

TEST(RequireWritable, CreatesNothing) {
  const TemporaryFolder folder;
  EXPECT_NO_THROW(requireWritable(folder / "a.png"));
  EXPECT_EQ(folder.fileCount(), 0U);
}

}  // namespace
}  // namespace opaline::core
