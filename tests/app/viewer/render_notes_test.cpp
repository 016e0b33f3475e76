#include "viewer/session/render_notes.h"

#include <gtest/gtest.h>

namespace opaline::app::viewer {
namespace {

using Strings = std::vector<std::string>;

class RenderNotesTest : public testing::Test {
 protected:
  RenderNotes notes;
  Strings further;
  LogCallback log =
      notes.taker([this](LogLevel, std::string_view message) { further.emplace_back(message); });
  RenderOptions options;
};

TEST_F(RenderNotesTest, NamesControlsAndRepeatsNothing) {
  for (int i = 0; i < 2; ++i) log(LogLevel::Note, "raise RenderOptions::maxClusters to 8192");
  log(LogLevel::Note, "raise RenderOptions::maxSurfels");
  log(LogLevel::Warning, "not of the scene");
  EXPECT_EQ(notes.all(), (Strings{"raise clusters under Method to 8192", "raise --max-surfels"}));
  EXPECT_EQ(further.size(), 4);
  notes.clear();
  EXPECT_EQ(notes.all(), Strings{});
}

TEST_F(RenderNotesTest, NotesOnPicturesThatDoNotLastGoNowhere) {
  notes.follow(options, true);
  log(LogLevel::Note, "the budget of 1024 clusters is small");
  EXPECT_EQ(notes.all(), Strings{});
  EXPECT_EQ(further, Strings{});
}

TEST_F(RenderNotesTest, AnotherBudgetIsNotedAnew) {
  notes.follow(options, false);
  log(LogLevel::Note, "too few");
  notes.follow(options, false);
  EXPECT_EQ(notes.all(), Strings{"too few"});
  options.maxClusters *= 2;
  notes.follow(options, false);
  EXPECT_EQ(notes.all(), Strings{});
}

}  // namespace
}  // namespace opaline::app::viewer
