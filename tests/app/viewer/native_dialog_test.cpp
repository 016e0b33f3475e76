#include "viewer/files/native_dialog.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

namespace opaline::app::viewer {
namespace {

using Names = std::vector<std::string>;

FileQuestion question(FileUse use, const char* name) {
  FileQuestion asked = questionFor(use);
  asked.folder = "/models/my own";
  asked.name = name;
  return asked;
}

TEST(NativeDialog, OutputIsOneNameWhateverItHolds) {
  EXPECT_EQ(fileIn("/a/b c.ply\n"), "/a/b c.ply");
  EXPECT_EQ(fileIn("/a/two\nlines.ply\n"), "/a/two\nlines.ply");
  EXPECT_EQ(fileIn("/a/ends in one\n\n"), "/a/ends in one\n");
  EXPECT_EQ(fileIn(""), std::nullopt);
  EXPECT_EQ(fileIn("relative\n"), std::nullopt);
}

// As the manuals of both programs have it.
TEST(NativeDialog, WhatProgramsAreAsked) {
  const DialogProgram zenity{"/usr/bin/zenity", false};
  EXPECT_EQ(argumentsFor(zenity, question(FileUse::OpenEnvironment, "")),
            (Names{"--file-selection", "--title=Open an environment", "--filename=/models/my own/",
                   "--file-filter=environments | *.hdr *.HDR *.exr *.EXR",
                   "--file-filter=all files | *"}));
  const Names saving = argumentsFor(zenity, question(FileUse::SavePicture, "bear"));
  EXPECT_EQ(std::count(saving.begin(), saving.end(), "--save"), 1);
  EXPECT_EQ(std::count(saving.begin(), saving.end(), "--confirm-overwrite"), 1);
  EXPECT_EQ(std::count(saving.begin(), saving.end(), "--filename=/models/my own/bear"), 1);
  const DialogProgram kdialog{"/usr/bin/kdialog", true};
  EXPECT_EQ(argumentsFor(kdialog, question(FileUse::SaveScene, "bear")),
            (Names{"--title", "Save the scene", "--getsavefilename", "/models/my own/bear",
                   "scenes (*.toml *.TOML)"}));
}

/// As the dialog ends when a shell runs this in its place.
struct Outcome {
  std::optional<std::filesystem::path> file;
  bool failed = false;
};

Outcome afterRunning(const std::string& program) {
  NativeDialog dialog({program, true}, question(FileUse::OpenScene, ""));
  while (dialog.isOpen()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  Outcome outcome;
  outcome.file = dialog.file();
  outcome.failed = dialog.failed();
  return outcome;
}

TEST(NativeDialog, NoChoiceIsNoFailure) {
  const Outcome left = afterRunning("/bin/false");  // ends with 1, as both do
  EXPECT_EQ(left.file, std::nullopt);
  EXPECT_FALSE(left.failed);
}

TEST(NativeDialog, AProgramThatNamesNoFileHasFailed) {
  EXPECT_TRUE(afterRunning("/bin/true").failed);
}

TEST(NativeDialog, ItIsOpenUntilTheProgramEnds) {
  ChildProcess reader("/bin/cat", {}, ChildProcess::Output::Kept);
  EXPECT_TRUE(reader.isRunning());
  ASSERT_TRUE(reader.write("/a/b\n"));
  EXPECT_TRUE(reader.finish());
  EXPECT_FALSE(reader.isRunning());
  EXPECT_EQ(reader.output(100), "/a/b\n");
  EXPECT_EQ(reader.output(2), "/a");
}

TEST(FileQuestion, ANameWithoutItsEndingGetsIt) {
  const FileQuestion picture = questionFor(FileUse::SavePicture);
  EXPECT_EQ(withExtension("/a/bear", picture), "/a/bear.png");
  EXPECT_EQ(withExtension("/a/bear.v2", picture), "/a/bear.v2.png");
  EXPECT_EQ(withExtension("/a/bear.PNG", picture), "/a/bear.PNG");
}

}  // namespace
}  // namespace opaline::app::viewer
