#include "viewer/session/loader.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "core/temporary_folder.h"

namespace opaline::app::viewer {
namespace {

using test::TemporaryFolder;

constexpr const char* tetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

SceneOptions sceneOf(const std::filesystem::path& file) {
  SceneOptions scene;
  scene.setFile(file);
  return scene;
}

Loader::Result resultOf(Loader& loader) {
  for (;;) {
    if (std::optional<Loader::Result> result = loader.take()) return std::move(*result);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

TEST(Loader, HandsOverTheSceneAndItsNotesOnce) {
  const TemporaryFolder folder;
  test::writeBytes(folder / "model.obj", tetrahedron);
  std::atomic<int> told = 0;
  Loader loader([&] { ++told; });
  EXPECT_FALSE(loader.take());
  loader.start(sceneOf(folder / "model.obj"));
  EXPECT_TRUE(loader.busy());
  EXPECT_EQ(loader.name(), "model");
  const Loader::Result result = resultOf(loader);
  ASSERT_TRUE(result.loaded) << result.error;
  EXPECT_EQ(result.loaded->scene.objects.size(), 1U);
  EXPECT_EQ(result.notes.size(), 1U);  // the file has no unit
  EXPECT_EQ(told, 1);
  EXPECT_FALSE(loader.busy());
  EXPECT_FALSE(loader.take());
}

TEST(Loader, SaysWhyThereIsNoScene) {
  const TemporaryFolder folder;
  Loader loader([] {});
  loader.start(sceneOf(folder / "nothing.obj"));
  const Loader::Result result = resultOf(loader);
  EXPECT_FALSE(result.loaded);
  EXPECT_NE(result.error.find("nothing.obj"), std::string::npos) << result.error;
}

TEST(Loader, ForgetsWhatItWasLoadingForTheNext) {
  const TemporaryFolder folder;
  for (const char* name : {"a.obj", "b.obj", "c.obj"}) test::writeBytes(folder / name, tetrahedron);
  std::atomic<int> told = 0;
  {
    Loader loader([&] { ++told; });
    for (const char* name : {"a.obj", "b.obj", "c.obj"}) loader.start(sceneOf(folder / name));
    EXPECT_EQ(resultOf(loader).loaded->scene.name, "c");
    loader.start(sceneOf(folder / "a.obj"));
  }  // goes away while it loads
  EXPECT_EQ(told, 4);
}

}  // namespace
}  // namespace opaline::app::viewer
