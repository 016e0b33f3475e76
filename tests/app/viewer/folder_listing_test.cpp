#include "viewer/files/folder_listing.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace opaline::app::viewer {
namespace {

namespace fs = std::filesystem;

class FolderListingTest : public testing::Test {
 protected:
  FolderListingTest() {
    std::string name = (fs::temp_directory_path() / "opaline_listing_XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~FolderListingTest() override { fs::remove_all(folder_); }

  void write(const std::string& name) const { std::ofstream(folder_ / name) << "x"; }
  void makeFolder(const std::string& name) const { fs::create_directory(folder_ / name); }

  std::vector<std::string> names(const std::vector<std::string>& extensions, bool hidden) const {
    std::vector<std::string> list;
    for (const FolderEntry& entry : listFolder(folder_, extensions, hidden).entries) {
      list.push_back(entry.name.string());
    }
    return list;
  }

  fs::path folder_;
};

using Names = std::vector<std::string>;

TEST_F(FolderListingTest, FoldersFirstAndNumbersInTheirOrder) {
  for (const char* name : {"m_10.ply", "m_9.ply", "M_1.ply", "bear.GLB", "notes.txt"}) write(name);
  for (const char* name : {"zebra", "Alps"}) makeFolder(name);
  EXPECT_EQ(names({".ply", ".glb"}, false),
            (Names{"Alps", "zebra", "bear.GLB", "M_1.ply", "m_9.ply", "m_10.ply"}));
}

TEST_F(FolderListingTest, HiddenAndOtherFilesOnlyWhereTheyAreAskedFor) {
  for (const char* name : {".hidden.ply", "a.ply", "b.txt"}) write(name);
  makeFolder(".config");
  EXPECT_EQ(names({".ply"}, false), (Names{"a.ply"}));
  EXPECT_EQ(names({}, true), (Names{".config", ".hidden.ply", "a.ply", "b.txt"}));
}

TEST_F(FolderListingTest, ALinkIsWhatItLeadsTo) {
  makeFolder("there");
  fs::create_directory_symlink(folder_ / "there", folder_ / "link");
  fs::create_symlink(folder_ / "nowhere", folder_ / "lost.ply");
  const FolderListing listing = listFolder(folder_, {".ply"}, false);
  ASSERT_EQ(listing.entries.size(), 3U);
  EXPECT_TRUE(listing.entries[0].isFolder);
  EXPECT_EQ(listing.entries[2].name, "lost.ply");
  EXPECT_FALSE(listing.entries[2].isFolder);
}

TEST_F(FolderListingTest, AFolderThatCannotBeReadSaysSo) {
  const FolderListing listing = listFolder(folder_ / "nothing", {}, false);
  EXPECT_TRUE(listing.entries.empty());
  EXPECT_NE(listing.error.find("nothing cannot be read"), std::string::npos) << listing.error;
}

TEST_F(FolderListingTest, NamesThatNobodyCanRead) {
  EXPECT_EQ(shownName("two\nlines\t"), "two?lines?");
  EXPECT_EQ(shownName("\xE5\xB7\xA5.ply"), "\xE5\xB7\xA5.ply");
  EXPECT_EQ(shownName("\xFF\x80-\xC3"),
            "?"
            "?-?");
  EXPECT_EQ(shownName("\xED\xA0\x80"), "???") << "a surrogate is no character";
}

TEST_F(FolderListingTest, TheFirstThatBeginsLikeThis) {
  for (const char* name : {"Bear.ply", "beast.ply", "cube.ply"}) write(name);
  const FolderListing listing = listFolder(folder_, {".ply"}, false);
  EXPECT_EQ(firstWith(listing, "bea"), 0U);
  EXPECT_EQ(firstWith(listing, "BEAS"), 1U);
  EXPECT_EQ(firstWith(listing, "d"), std::nullopt);
  EXPECT_EQ(firstWith(listing, ""), std::nullopt);
}

TEST_F(FolderListingTest, APathThatWasTyped) {
  EXPECT_EQ(typedPath("/a/b", "c.ply"), "/a/b/c.ply");
  EXPECT_EQ(typedPath("/a/b", "../c/"), "/a/c");
  EXPECT_EQ(typedPath("/a/b", "/d/e f"), "/d/e f");
  EXPECT_EQ(typedPath("/a/b", "/"), "/");
  EXPECT_EQ(typedPath("/a/b", "~/x"), homeFolder() / "x");
  EXPECT_EQ(typedPath("/a/b", "~x"), "/a/b/~x");
}

}  // namespace
}  // namespace opaline::app::viewer
