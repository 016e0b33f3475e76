#include "viewer/session/truth_view.h"

#include <fmt/format.h>

#include <utility>

#include "cli/paths.h"
#include "film/film_output.h"
#include "opaline/compare.h"
#include "opaline/error.h"

namespace opaline::app::viewer {

namespace {

constexpr int blockEdge = 8;

// The linear values that tone curve None and exposure 0 show as the encoded ones.
Image linear(const Image8& encoded) {
  Image image(encoded.width, encoded.height);
  for (std::size_t i = 0; i < encoded.rgba.size(); ++i) {
    const float value = static_cast<float>(encoded.rgba[i]) / 255;
    image.rgba[i] = i % 4 == 3 ? value : decodeSrgb(value);
  }
  return image;
}

}  // namespace

void TruthView::start(const Session& session, Renderer& renderer, TruthOrder::Method method,
                      int width, int height) {
  cancel();
  RenderOptions options = sized(session.options, width, height);
  options.specular = false;
  picture_ = pictureOf(session, renderer, options);
  TruthOrder order;
  order.method = method;
  // Half of the cores stay free for the window.
  order.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()) + 1) / 2;
  job_ =
      std::make_unique<TruthJob>(session.scene, session.time, options, order, session.positionsMm);
  running_ = true;
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
  drawnHeatMap_ = compare::drawHeatmap(errors, common, compare::heatmapTop(errors, common));
  heatMap_.set(linear(drawnHeatMap_));
  return true;
}

std::string TruthView::legend() const {
  if (!latest_) return "there is no truth yet";
  std::string text =
      fmt::format("truth after {:.1f} s, within {} %", latest_->seconds,
                  latest_->error < 0.1 ? fmt::format("{:.2g}", 100 * latest_->error)
                                       : fmt::format("{:.0f}", 100 * latest_->error));
  if (blocks_) {
    text += fmt::format("; the picture's blocks of {0} x {0} are off by {1:.2f} %", blockEdge,
                        100 * blocks_->relRmse);
  }
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
