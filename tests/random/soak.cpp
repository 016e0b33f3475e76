// opaline_soak FRAMES [SEED]: renders small frames with one renderer, and edits media, lights,
// bodies, sizes, methods and views at random. Memory must not grow, and a fresh renderer must make
// every twentieth picture, or a thousand of a longer run, the same bit by bit.

#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "opaline/options/field.h"
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
    order_ = drawOrder(*shown.view);
    images_ = shown.view->render(order_).images;
    requireSound();
  }

  /// Throws where a fresh renderer makes different pictures of the last scene.
  void compare() const {
    Renderer fresh;
    fresh.setScene(drawn_.scene);
    fresh.setTime(time_);
    for (const auto& [object, positionsMm] : replaced_) fresh.replacePositions(object, positionsMm);
    View view(fresh, last_->view->options());
    view.setCamera(last_->camera);
    const std::vector<Image> expected = view.render({.aovs = order_.aovs}).images;
    for (std::size_t i = 0; i < expected.size(); ++i)
      requireEqual(images_.at(i), expected[i], options::nameOf(order_.aovs[i]));
  }

  std::uint64_t edits() const { return edits_; }
  std::uint64_t scenes() const { return scenes_; }

 private:
  struct Shown {
    std::unique_ptr<View> view;
    Camera camera;
  };

  static void requireEqual(const Image& image, const Image& expected, std::string_view name) {
    std::size_t different = 0;
    float most = 0;
    for (std::size_t i = 0; i < expected.rgba.size(); ++i) {
      if (image.rgba.at(i) == expected.rgba[i]) continue;
      ++different;
      most = std::max(most, std::abs(image.rgba[i] - expected.rgba[i]));
    }
    if (different > 0)
      throw std::runtime_error(
          fmt::format("a fresh renderer makes another picture: {} of {} values of {} differ, by {} "
                      "at most",
                      different, expected.rgba.size(), name, most));
  }

  // Light is finite and not negative.
  void requireSound() const {
    for (std::size_t i = 0; i < images_.size(); ++i) {
      if (order_.aovs[i] == Aov::Surfels) continue;
      for (const float value : images_[i].rgba)
        if (!std::isfinite(value) || value < 0)
          throw std::runtime_error(
              fmt::format("{} is {} in a pixel", options::nameOf(order_.aovs[i]), value));
    }
  }

  FrameOrder drawOrder(const View& view) {
    FrameOrder order;
    order.reuseLight = dice_.chance(.5F);
    if (dice_.chance(.8F)) return order;
    const bool surfels = view.options().sum != Sum::Pattern;
    order.aovs = {Aov::Radiance, Aov::Exitance, Aov::Irradiance,
                  surfels ? Aov::Surfels : Aov::DsmIrradiance};
    order.aovs.erase(order.aovs.begin() + dice_.below(4));
    return order;
  }

  void showAnotherScene() {
    views_.clear();
    drawn_ = drawSceneOfAllKinds(dice_);
    renderer_.setScene(drawn_.scene);
    replaced_.clear();
    time_ = {};
    views_.push_back(anotherView());
    ++scenes_;
  }

  Shown anotherView() {
    Shown shown{std::make_unique<View>(renderer_, anotherOptions()),
                drawCamera(dice_, drawn_.sizeMm, drawn_.middleMm)};
    shown.view->setCamera(shown.camera);
    return shown;
  }

  void edit() {
    ++edits_;
    const auto object = static_cast<std::size_t>(dice_.below(static_cast<int>(drawn_.bodies)));
    constexpr std::size_t mostViews = 3;
    // Most edits are of the kinds that frequently occur.
    switch (const int kind = dice_.below(200)) {
      case 0:
        return showAnotherScene();
      case 1: {  // another body in its place, with all the rest as it was
        drawn_.scene.objects[object].mesh = drawBody(dice_, drawn_.sizeMm / 2, drawn_.middleMm);
        renderer_.setScene(drawn_.scene);
        replaced_.clear();
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
        if (kind < 14) return setMedium(object);
        if (kind < 20) return setMaterial(object);
        if (kind < 26) return movePositions(object);
        if (kind < 30) {
          drawn_.scene.deformers = drawDeformers(dice_);
          return renderer_.setDeformers(drawn_.scene.deformers);
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

  // Mostly so small that a frame is more edits than light.
  RenderOptions anotherOptions() {
    RenderOptions options = drawOptions(dice_, drawn_.scene);
    if (dice_.chance(.1F)) return options;
    options.maxSurfels = 1024;
    options.maxClusters = 64;
    return options;
  }

  void setOptions(Shown& shown) { shown.view->setOptions(anotherOptions()); }

  void setMedium(std::size_t object) {
    Object& its = drawn_.scene.objects[object];
    if (its.opaque) return;
    its.medium = drawMedium(dice_, drawn_.sizeMm);
    renderer_.setMedium(object, its.medium);
  }

  void setMaterial(std::size_t object) {
    Object& its = drawn_.scene.objects[object];
    Material material = drawMaterial(dice_, drawn_.sizeMm, its.opaque.has_value());
    if (anyPattern()) material.paint.reset();
    giveMaterial(material, its);
    renderer_.setMaterial(object, material);
  }

  // Stretches a body, or gives it its own shape again.
  void movePositions(std::size_t object) {
    if (dice_.chance(.4F)) {
      replaced_.erase(object);
      return renderer_.restorePositions(object);
    }
    std::vector<Vec3> positionsMm = drawn_.scene.objects[object].mesh.positionsMm;
    const auto axis = static_cast<std::size_t>(dice_.below(3));
    const float factor = dice_.between(.5F, 1.5F);
    const float middle = drawn_.middleMm[axis];
    for (Vec3& at : positionsMm) at[axis] = middle + factor * (at[axis] - middle);
    renderer_.replacePositions(object, positionsMm);
    replaced_[object] = std::move(positionsMm);
  }

  // Every view must support all there is.
  bool anyPattern() const {
    return std::any_of(views_.begin(), views_.end(), [](const Shown& shown) {
      return shown.view->options().sum == Sum::Pattern;
    });
  }

  void setLighting() {
    drawn_.scene.lighting = drawLighting(dice_, drawn_.sizeMm, drawn_.middleMm);
    if (anyPattern()) drawn_.scene.lighting.areas.clear();
    renderer_.setLighting(drawn_.scene.lighting);
  }

  Dice dice_;
  Renderer renderer_;
  DrawnScene drawn_;
  SceneTime time_;
  std::vector<Shown> views_;
  std::map<std::size_t, std::vector<Vec3>> replaced_;  // positions given for objects
  const Shown* last_ = nullptr;
  FrameOrder order_;  // of the last frame
  std::vector<Image> images_;
  std::uint64_t edits_ = 0;
  std::uint64_t scenes_ = 0;
};

int run(std::uint64_t frames, std::uint32_t seed) {
  Soak soak(seed);
  const Clock::time_point begin = Clock::now();
  // By then everything has been at its largest.
  const std::uint64_t warm = std::max<std::uint64_t>(frames / 4, 1);
  const std::uint64_t framesPerComparison = std::max<std::uint64_t>(frames / 1000, 20);
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
