#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lab/truth_job.h"
#include "opaline/compare.h"
#include "opaline/image.h"
#include "opaline/image_file.h"
#include "opaline/renderer.h"
#include "opaline/tone.h"
#include "viewer/picture/host_picture.h"
#include "viewer/session/session.h"

namespace opaline::app::viewer {

/// The colours of heat maps, from no error to the largest.
const std::vector<Rgb>& heatMapColors();

/// The truth of what the window shows, computed in the background. It keeps the picture to compare
/// it with, and how far the two differ.
class TruthView {
 public:
  explicit TruthView(const VulkanDevice& device) : truth_(device), heatMap_(device) {}

  /// Starts on the session as it is now. The picture to compare with is rendered at once, without
  /// reflections, by `renderer`, which must have no frame under way.
  void start(const Session& session, Renderer& renderer, TruthOrder::Method method, int width,
             int height);
  void cancel();
  /// Cancels it, and drops what it has found, which is of no use for another scene.
  void forget();
  /// Notes that the picture is no longer of the scene that the truth was started with.
  void noteEdit() { isOfNow_ = false; }
  /// The same if the session's edits or its time say so.
  void follow(const Session& session);
  /// Whether the figures are of the picture as it is now.
  bool isOfNow() const { return isOfNow_; }
  /// As of the last update(), so that a caller who waits for the end does not miss it.
  bool running() const { return running_; }
  double progress() const { return job_ ? job_->progress() : 0; }

  /// Takes over new results. True if there is something new to see or the job has ended.
  bool update();

  bool hasPicture() const { return !truth_.empty(); }
  const DeviceImage& truth() const { return truth_.shown(); }
  const DeviceImage& heatMap() const { return heatMap_.shown(); }
  /// The relative error that has the last of the heat map's colours.
  double heatMapTop() const { return heatMapTop_; }
  const std::optional<compare::Figures>& figures() const { return figures_; }
  const std::optional<compare::BlockFigures>& blocks() const { return blocks_; }
  const std::shared_ptr<const TruthPicture>& latest() const { return latest_; }
  /// One sentence on what the pictures show and how far the window's picture differs.
  std::string legend() const;
  /// Writes its last picture, or the heat map. Returns a sentence that says so. Throws Error.
  std::string save(TruthFile what, const Target& target, const ToneOptions& tone) const;
  std::string error() const { return job_ ? job_->error() : std::string(); }

 private:
  bool takePicture(std::shared_ptr<const TruthPicture> latest);

  std::unique_ptr<TruthJob> job_;
  bool running_ = false;
  bool isOfNow_ = true;
  SceneTime time_;
  Image picture_;  // what the truth is compared with
  std::shared_ptr<const TruthPicture> latest_;
  HostPicture truth_;
  HostPicture heatMap_;
  Image8 drawnHeatMap_;  // with its scale
  double heatMapTop_ = 0;
  std::optional<compare::Figures> figures_;
  std::optional<compare::BlockFigures> blocks_;
};

}  // namespace opaline::app::viewer
