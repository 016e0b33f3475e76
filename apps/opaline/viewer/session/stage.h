#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <vector>

#include "opaline/renderer.h"
#include "opaline/vulkan.h"
#include "viewer/picture/host_picture.h"
#include "viewer/session/session.h"
#include "viewer/window/queue_watch.h"

namespace opaline::app::viewer {

/// Keeps a renderer in step with a session and has it make the pictures the window shows.
///
/// Where the window is drawn by the renderer's device, a frame is waited for only when the one
/// after the next begins. Where it has a device of its own, nothing is waited for: one picture at a
/// time is under way, and is brought over when it is done.
class Stage {
 public:
  Stage(Renderer& renderer, const VulkanDevice& window);
  Stage(const Stage&) = delete;  // it points into itself
  Stage& operator=(const Stage&) = delete;

  /// From now on it is this scene. Throws Error where the renderer refuses it, which then has the
  /// one before again, if there was one; what was placed in that is to be placed anew.
  void setScene(const Scene& scene, const Scene& before);
  bool hasScene() const { return hasScene_; }

  /// Hands the session's edits to the renderer and has it draw the picture, and the paper's where
  /// the session is divided; the variable that the session shows, where that is another, comes a
  /// frame later. While something is `moving`, pictures come fast: one sample a pixel, and coarser
  /// light where the session allows it and its transport took long. Not while it is busy. Throws
  /// Error where the renderer does, and can be called again.
  void draw(Session& session, int width, int height, bool moving);
  /// Whether there is a picture to be taken up, now or once it is done.
  bool isUnderWay() const { return apart_ && !waiting_.empty(); }
  /// Whether it is not done yet, so that nobody should wait for it.
  bool isBusy() const { return isUnderWay() && !watch_.isDone(); }
  /// Since when it is busy with that picture.
  std::chrono::steady_clock::time_point busySince() const { return busySince_; }
  /// Takes up a picture that is done.
  void takeUp();
  /// Waits for what is under way.
  void finish();

  const DeviceImage& picture() const { return apart_ ? hostPicture_.shown() : picture_; }
  /// The paper's picture, while the session is divided.
  std::optional<DeviceImage> paper() const;
  /// Whether the light in it is found more coarsely than the session says.
  bool isCoarse() const { return coarse_; }
  /// The last frame that finished, of the session's own method.
  const Frame& lastFrame() const { return frame_; }
  /// The variable in it and its values; none where only radiance was wanted.
  Aov variable() const { return variable_; }
  const Image* variableImage() const;
  std::size_t framesFinished() const { return framesFinished_; }
  /// Of that frame, also where it was of a scene that is gone by now.
  const RenderReport& report() const { return report_; }

 private:
  struct Waiting {
    View* view = nullptr;
    Aov variable = Aov::Radiance;
  };

  Edits handOver(Session& session);
  View& viewFor(const RenderOptions& options, const Edits& edits);
  void submit(View& view, Aov variable);
  void collect();
  bool isPaper(const View& view) const { return paper_ && &view == &*paper_; }

  Renderer& renderer_;
  const bool apart_;  // the window has a device of its own
  bool hasScene_ = false;
  bool divided_ = false;
  View view_;
  std::optional<View> coarseView_;  // on a coarse division; none until something moves
  std::optional<View> paper_;       // of the paper's method; none until the session is divided
  DeviceImage picture_;
  DeviceImage paperPicture_;
  HostPicture hostPicture_;
  HostPicture hostPaper_;
  QueueWatch watch_;  // of the frames under way
  Frame frame_;
  RenderReport report_;
  Frame other_;  // of the paper's method
  Aov variable_ = Aov::Radiance;
  std::vector<Waiting> waiting_;  // frames under way, oldest first
  std::chrono::steady_clock::time_point busySince_;
  bool coarse_ = false;
  bool resting_ = true;  // the frame drawn last was not in motion
  double restMs_ = 0;    // of the last one at rest that found its light
  std::size_t restSurfels_ = 0;
  std::size_t framesFinished_ = 0;
  FrameOrder order_;
};

}  // namespace opaline::app::viewer
