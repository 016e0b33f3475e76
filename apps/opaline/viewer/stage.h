#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "opaline/renderer.h"
#include "opaline/vulkan.h"
#include "viewer/session.h"

namespace opaline::app::viewer {

/// Keeps a renderer in step with a session and has it make the pictures the window shows. Every
/// frame goes to the device and is waited for only when the one after the next begins.
class Stage {
 public:
  explicit Stage(Renderer& renderer) : renderer_(renderer) {}

  /// From now on it is this session's scene.
  void setScene(const Scene& scene);
  bool hasScene() const { return hasScene_; }

  /// Hands the session's edits to the renderer and has it draw the picture, and the paper's where
  /// the session is divided; the variable that the session shows, where that is another, comes a
  /// frame later. While something is `moving`, pictures come fast: one sample a pixel, and
  /// half-spaces where the session allows it and its transport took long.
  void draw(Session& session, int width, int height, bool moving);
  /// Waits for what is under way.
  void finish();

  const DeviceImage& picture() const { return picture_; }
  /// The paper's picture, while the session is divided.
  const std::optional<DeviceImage>& paper() const { return paper_; }
  /// Whether half-spaces stand in for the session's transport in it.
  bool isPreview() const { return preview_; }
  /// The last frame that finished, of the session's own method.
  const Frame& lastFrame() const { return frame_; }
  std::size_t framesFinished() const { return framesFinished_; }
  RenderReport report() const { return renderer_.report(); }

 private:
  bool handOver(Session& session);
  void submit(const RenderOptions& options, const std::vector<Aov>& aovs, DeviceImage& to,
              bool own);
  void collect();

  Renderer& renderer_;
  bool hasScene_ = false;
  DeviceImage picture_;
  std::optional<DeviceImage> paper_;
  Frame frame_;
  Frame other_;                // of the paper's method
  std::vector<bool> waiting_;  // frames under way, oldest first: whether of the own method
  bool preview_ = false;
  bool resting_ = true;  // the frame drawn last was not in motion
  double restMs_ = 0;    // of the last one at rest that found its light
  std::size_t framesFinished_ = 0;
  std::vector<Aov> aovs_;
};

}  // namespace opaline::app::viewer
