#include "film/film_job.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cli/child_process.h"
#include "core/temporary_folder.h"
#include "opaline/error.h"
#include "renderer/renderer_fixture.h"
#include "renderer/shapes.h"

namespace opaline::app {
namespace {

namespace fs = std::filesystem;
using test::readBytes;

/// A ball that swings, five frames of it.
class Film : public test::RendererTestBase<testing::Test> {
 protected:
  void SetUp() override {
    RendererTestBase::SetUp();
    Scene scene = test::sceneOf(test::sphere({0, 0, 0}, 5, 3), test::marble(), {0, 0, 40}, 8);
    scene.lighting.directional.push_back({{0.8F, 0, 0.6F}, {1, 2, 3}});
    scene.deformers = {{DeformerKind::Twist, 0.5F, 1}, {DeformerKind::Squash, 0.4F, 1}};
    renderer().setScene(scene);
  }

  FilmOrder order(const std::string& name) const {
    FilmOrder order;
    order.frames = {3, 7, 10};
    order.output = folder / name;
    order.options.width = 24;
    order.options.height = 16;
    order.options.transport = Transport::Dipole;
    order.options.maxSurfels = 1024;
    order.quiet = true;
    return order;
  }

  /// What a window does between two frames of a film.
  void drawSomethingElse() {
    RenderOptions other;
    other.width = 40;
    other.height = 30;
    other.transport = Transport::Dipole;
    renderer().setTime({.seconds = 0.77});
    renderer().render(other);
  }

  std::vector<std::string> listing() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder.path())) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  test::TemporaryFolder folder;
};

TEST_F(Film, StepByStepThePicturesAreTheSame) {
  EXPECT_EQ(renderFilm(renderer(), order("once_%d.png")).frames, 5U);
  for (const std::size_t atOnce : {1U, 2U, 9U}) {
    FilmJob job(order("steps_%d.png"));
    EXPECT_EQ(job.progress().share(), 0);
    while (!job.isDone()) {
      drawSomethingElse();
      job.step(renderer(), atOnce);
    }
    drawSomethingElse();
    EXPECT_EQ(job.progress().share(), 1);
    EXPECT_EQ(job.progress().written, 5U);
    for (const char* number : {"3", "4", "5", "6", "7"}) {
      const fs::path steps = folder / ("steps_" + std::string(number) + ".png");
      EXPECT_EQ(readBytes(steps), readBytes(folder / ("once_" + std::string(number) + ".png")));
      fs::remove(steps);
    }
  }
  EXPECT_NE(readBytes(folder / "once_3.png"), readBytes(folder / "once_5.png"));
}

TEST_F(Film, IsThereWhenItIsDoneAndNotBefore) {
  if (!findProgram("ffmpeg")) GTEST_SKIP() << "there is no ffmpeg";
  renderFilm(renderer(), order("once.mp4"));
  FilmJob job(order("steps.mp4"));
  while (!job.isDone()) {
    EXPECT_FALSE(fs::exists(folder / "steps.mp4"));
    drawSomethingElse();
    job.step(renderer());
  }
  EXPECT_EQ(readBytes(folder / "steps.mp4"), readBytes(folder / "once.mp4"));
  EXPECT_THAT(listing(), testing::ElementsAre("once.mp4", "steps.mp4"));
}

TEST_F(Film, LeavesNothingWhenItGoesAway) {
  if (!findProgram("ffmpeg")) GTEST_SKIP() << "there is no ffmpeg";
  test::writeBytes(folder / "film.mp4", "the old one");
  for (std::size_t frames = 0; frames < 5; ++frames) {
    FilmJob job(order("film.mp4"));
    job.step(renderer(), frames);
  }
  EXPECT_THAT(listing(), testing::ElementsAre("film.mp4"));
  EXPECT_EQ(readBytes(folder / "film.mp4"), "the old one");
}

TEST_F(Film, PicturesAreWholeOrNotThere) {
  {
    FilmJob job(order("f%d.png"));
    job.step(renderer(), 4);
  }
  const std::vector<std::string> before = listing();
  EXPECT_LE(before.size(), 4U);
  FilmOrder rest = order("f%d.png");
  rest.resume = true;
  FilmJob job(rest);
  job.step(renderer(), 5);
  EXPECT_TRUE(job.isDone());
  EXPECT_EQ(job.progress().skipped, before.size());
  EXPECT_EQ(job.progress().written, 5 - before.size());
  EXPECT_THAT(listing(), testing::ElementsAre("f3.png", "f4.png", "f5.png", "f6.png", "f7.png"));
}

TEST_F(Film, AFrameThatFailsLosesNoneBeforeIt) {
  FilmOrder failing = order("f%d.png");
  failing.place = [](Renderer&, int frame) {
    if (frame == 6) throw Error("frame 6 is broken");
  };
  {
    FilmJob job(failing);
    EXPECT_EQ(test::messageOf([&] { job.step(renderer(), 5); }), "frame 6 is broken");
    EXPECT_FALSE(job.isDone());
  }
  EXPECT_THAT(listing(), testing::ElementsAre("f3.png", "f4.png", "f5.png"));
  drawSomethingElse();  // nothing is under way
}

TEST_F(Film, SaysAtOnceWhatCannotBeWritten) {
  for (const char* name : {"none/f%d.png", "none/film.mp4"}) {
    EXPECT_THAT(test::messageOf([&] { const FilmJob job(order(name)); }),
                testing::HasSubstr("folder"));
  }
  FilmOrder gone = order("there/f%d.png");
  fs::create_directory(folder / "there");
  FilmJob job(gone);
  fs::remove(folder / "there");
  EXPECT_THAT(test::messageOf([&] { job.step(renderer(), 5); }), testing::HasSubstr("f"));
  drawSomethingElse();
}

}  // namespace
}  // namespace opaline::app
