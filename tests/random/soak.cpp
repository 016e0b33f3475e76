// opaline_soak FRAMES [SEED]: renders small frames with one renderer, and edits media, lights,
// bodies, sizes, methods and views at random. Memory must not grow, and a fresh renderer must make
// every twentieth picture the same bit by bit.

#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "opaline/renderer.h"
#include "random/drawn_scene.h"

namespace opaline::test {

namespace {

using Clock = std::chrono::steady_clock;

double residentMegabytes() {
  std::ifstream file("/proc/self/statm");
  double pages = 0;
  file >> pages >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

/// Memory allocated and not freed, without the allocator's own.
double allocatedMegabytes() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd) / 1e6;
}

std::size_t openFiles() {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd"))
    if (entry.exists()) ++count;
  return count;
}

/// A renderer, its scene, and views of it.
class Soak {
 public:
  explicit Soak(std::uint32_t seed) : dice_(seed) { showAnotherScene(); }

  void frame() {
    edit();
    Shown& shown = views_[static_cast<std::size_t>(dice_.below(static_cast<int>(views_.size())))];
    last_ = &shown;
    picture_ = shown.view->render({.patient = true, .reuseLight = dice_.chance(.5F)}).images.at(0);
  }

  /// Throws where a fresh renderer makes a different picture of the last scene.
  void compare() const {
    Renderer fresh;
    fresh.setScene(drawn_.scene);
    fresh.setTime(time_);
    View view(fresh, last_->view->options());
    view.setCamera(last_->camera);
    const std::vector<float> expected = view.render().images.at(0).rgba;
    std::size_t different = 0;
    float most = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      if (expected[i] == picture_.rgba.at(i)) continue;
      ++different;
      most = std::max(most, std::abs(expected[i] - picture_.rgba[i]));
    }
    if (different > 0)
      throw std::runtime_error(fmt::format(
          "a fresh renderer makes another picture: {} of {} values differ, by {} at most",
          different, expected.size(), most));
  }

  std::uint64_t edits() const { return edits_; }
  std::uint64_t scenes() const { return scenes_; }

 private:
  struct Shown {
    std::unique_ptr<View> view;
    Camera camera;
  };

  void showAnotherScene() {
    views_.clear();
    drawn_ = drawScene(dice_);
    renderer_.setScene(drawn_.scene);
    time_ = {};
    views_.push_back(anotherView());
    ++scenes_;
  }

  Shown anotherView() {
    Shown shown{std::make_unique<View>(renderer_, drawOptions(dice_, drawn_.scene)),
                drawCamera(dice_, drawn_.sizeMm, drawn_.middleMm)};
    shown.view->setCamera(shown.camera);
    return shown;
  }

  void edit() {
    ++edits_;
    const auto object =
        static_cast<std::size_t>(dice_.below(static_cast<int>(drawn_.scene.objects.size())));
    constexpr std::size_t mostViews = 3;
    // Most edits are of the kinds that frequently occur.
    switch (const int kind = dice_.below(200)) {
      case 0:
        return showAnotherScene();
      case 1: {  // another body in its place, with all the rest as it was
        drawn_.scene.objects[object].mesh = drawBody(dice_, drawn_.sizeMm / 2, drawn_.middleMm);
        renderer_.setScene(drawn_.scene);
        time_ = {};
        return;
      }
      case 2:
      case 3:
        if (views_.size() == mostViews) views_.erase(views_.begin());
        views_.push_back(anotherView());
        return;
      default:
        if (kind < 10) return setOptions(views_.back());
        if (kind < 20) {
          const Medium medium = drawMedium(dice_, drawn_.sizeMm);
          drawn_.scene.objects[object].medium = medium;
          return renderer_.setMedium(object, medium);
        }
        if (kind < 60) return setLighting();
        if (kind < 120) {
          for (Shown& shown : views_) {
            shown.camera = drawCamera(dice_, drawn_.sizeMm, drawn_.middleMm);
            shown.view->setCamera(shown.camera);
          }
          return;
        }
        time_.seconds = static_cast<double>(dice_.between(0, 3));
        renderer_.setTime(time_);
    }
  }

  void setOptions(Shown& shown) { shown.view->setOptions(drawOptions(dice_, drawn_.scene)); }

  void setLighting() {
    drawn_.scene.lighting = drawLighting(dice_, drawn_.sizeMm, drawn_.middleMm);
    // Every view must support all lights.
    for (Shown& shown : views_)
      if (shown.view->options().sum == Sum::Pattern) drawn_.scene.lighting.areas.clear();
    renderer_.setLighting(drawn_.scene.lighting);
  }

  Dice dice_;
  Renderer renderer_;
  DrawnScene drawn_;
  SceneTime time_;
  std::vector<Shown> views_;
  const Shown* last_ = nullptr;
  Image picture_;
  std::uint64_t edits_ = 0;
  std::uint64_t scenes_ = 0;
};

int run(std::uint64_t frames, std::uint32_t seed) {
  Soak soak(seed);
  const Clock::time_point begin = Clock::now();
  // By then everything has been at its largest.
  const std::uint64_t warm = std::max<std::uint64_t>(frames / 4, 1);
  constexpr std::uint64_t framesPerComparison = 20;
  const std::uint64_t framesPerReport = std::max<std::uint64_t>(frames / 40, framesPerComparison);
  double early = 0;
  double late = 0;
  std::size_t compared = 0;
  for (std::uint64_t i = 1; i <= frames; ++i) {
    try {
      soak.frame();
      if (i % framesPerComparison == 0) {
        soak.compare();
        ++compared;
      }
    } catch (const std::exception& error) {
      fmt::print("frame {} of seed {}: {}\n", i, seed, error.what());
      return 1;
    }
    if (i % framesPerReport != 0) continue;
    malloc_trim(0);  // holes between blocks do not count as growth
    const double megabytes = residentMegabytes();
    fmt::print(stderr, "{} of {} frames, {:.0f} MB, {:.0f} MB of it allocated\n", i, frames,
               megabytes, allocatedMegabytes());
    if (i <= warm) early = std::max(early, megabytes);
    if (i > frames - warm) late = std::max(late, megabytes);
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  fmt::print(
      "{} frames, {} edits, {} scenes, {} pictures as a fresh renderer makes them, {:.0f} s; at "
      "most {:.0f} MB in the first quarter and {:.0f} MB in the last, {} open files\n",
      frames, soak.edits(), soak.scenes(), compared, seconds, early, late, openFiles());
  // Fewer frames have not used every pipeline.
  constexpr double allowance = 1.1;
  constexpr std::uint64_t fewest = 10'000;
  if (frames < fewest || late <= allowance * early + 8) return 0;
  fmt::print("memory grows\n");
  return 1;
}

}  // namespace

}  // namespace opaline::test

int main(int count, char** values) {
  const std::uint64_t frames = count > 1 ? std::strtoull(values[1], nullptr, 10) : 1'000'000;
  const auto seed =
      static_cast<std::uint32_t>(count > 2 ? std::strtoul(values[2], nullptr, 10) : 1);
  return opaline::test::run(frames, seed);
}
