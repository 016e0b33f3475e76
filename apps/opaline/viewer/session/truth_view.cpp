#include "viewer/session/truth_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "cli/paths.h"
#include "film/film_output.h"
#include "opaline/compare.h"
#include "opaline/error.h"

namespace opaline::app::viewer {

namespace {

constexpr int blockEdge = 8;

// The linear values that tone curve None and exposure 0 show as the encoded ones, of the top left
// part of an opaque picture.
Image linear(const Image8& encoded, int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto from = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(encoded.width) +
                             static_cast<std::size_t>(x));
      const auto to = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                           static_cast<std::size_t>(x));
      for (std::size_t c = 0; c < 3; ++c)
        image.rgba[to + c] = decodeSrgb(static_cast<float>(encoded.rgba[from + c]) / 255);
      image.rgba[to + 3] = 1;
    }
  }
  return image;
}

}  // namespace

const std::vector<Rgb>& heatMapColors() {
  static const std::vector<Rgb> colors = [] {
    constexpr int steps = 64;
    compare::Plane errors(1, steps);
    for (int i = 0; i < steps; ++i)
      errors.values[static_cast<std::size_t>(i)] =
          static_cast<float>(i) / static_cast<float>(steps - 1);
    const Image8 drawn = compare::drawHeatmap(errors, compare::Selection(steps, 1), 1);
    std::vector<Rgb> found(steps);
    for (std::size_t i = 0; i < found.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c)
        found[i][c] =
            static_cast<float>(drawn.rgba[4 * i * static_cast<std::size_t>(drawn.width) + c]) / 255;
    }
    return found;
  }();
  return colors;
}

void TruthView::start(const Session& session, Renderer& renderer, TruthOrder::Method method,
                      int width, int height) {
  cancel();
  RenderOptions options = sized(session.options, width, height);
  options.specular = false;
  picture_ = pictureOf(session, renderer, options, Aov::Radiance);
  TruthOrder order;
  order.method = method;
  // Half of the cores stay free for the window.
  order.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()) + 1) / 2;
  job_ =
      std::make_unique<TruthJob>(session.scene, session.time, options, order, session.positionsMm);
  running_ = true;
  isOfNow_ = true;
  time_ = session.time;
}

void TruthView::follow(const Session& session) {
  const Edits& edits = session.edits;
  const bool material =
      std::find(edits.material.begin(), edits.material.end(), true) != edits.material.end();
  if (edits.camera || edits.lighting || edits.deformers || edits.ground || material ||
      session.time != time_)
    noteEdit();
}

void TruthView::cancel() {
  job_.reset();
  running_ = false;
}

void TruthView::forget() {
  cancel();
  latest_.reset();
  truth_.clear();
  heatMap_.clear();
  figures_.reset();
  blocks_.reset();
}

bool TruthView::update() {
  if (!job_) return false;
  // The state is read before the picture, so that the last picture is there once the job has ended.
  const bool running = job_->state() == TruthJob::State::Running;
  const bool ended = std::exchange(running_, running) && !running;
  return takePicture(job_->picture()) || ended;
}

bool TruthView::takePicture(std::shared_ptr<const TruthPicture> latest) {
  if (!latest || latest == latest_) return false;
  latest_ = std::move(latest);
  truth_.set(latest_->image);
  const compare::Selection common = compare::commonPixels(picture_, latest_->image);
  figures_ = compare::figuresOver(picture_, latest_->image, common);
  blocks_ = compare::blockFiguresOver(picture_, latest_->image, common, blockEdge);
  const compare::Plane errors =
      compare::relativeBlockErrors(picture_, latest_->image, common, blockEdge);
  heatMapTop_ = compare::heatmapTop(errors, common);
  drawnHeatMap_ = compare::drawHeatmap(errors, common, heatMapTop_);
  // The window draws a scale of its own, as large as its text.
  heatMap_.set(linear(drawnHeatMap_, errors.width, errors.height));
  return true;
}

std::string TruthView::legend() const {
  if (!latest_) return "there is no truth yet";
  std::string text = fmt::format("truth after {:.1f} s", latest_->seconds);
  // Where hardly any light comes out, an error relative to it means nothing.
  if (std::isfinite(latest_->error)) {
    text += fmt::format(", within {} %", latest_->error < 0.1
                                             ? fmt::format("{:.2g}", 100 * latest_->error)
                                             : fmt::format("{:.0f}", 100 * latest_->error));
  }
  if (blocks_) {
    text += fmt::format("; the picture's blocks of {0} x {0} are off by {1:.2f} %", blockEdge,
                        100 * blocks_->relRmse);
  }
  if (!isOfNow_) text += "; all of this is of the scene as it was when the truth was started";
  return text;
}

std::string TruthView::save(TruthFile what, const Target& target, const ToneOptions& tone) const {
  if (!latest_) throw Error("there is no truth to save yet");
  const std::filesystem::path file = what == TruthFile::HeatMap
                                         ? writePng(target, drawnHeatMap_)
                                         : writePicture(target, latest_->image, tone);
  return fmt::format("saved {}", nameText(file, target.path));
}

}  // namespace opaline::app::viewer
