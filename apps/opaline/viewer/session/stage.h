#pragma once

#include <chrono>
#include <cstddef>
#include <future>
#include <optional>
#include <vector>

#include "opaline/moment.h"
#include "opaline/renderer.h"
#include "opaline/vulkan.h"
#include "viewer/picture/host_picture.h"
#include "viewer/session/render_notes.h"
#include "viewer/session/session.h"
#include "viewer/window/queue_watch.h"

namespace opaline::app::viewer {

/// Keeps a renderer in step with a session and makes it render the pictures that the window shows.
///
/// Where the renderer's device also draws the window, a frame is waited for only when the next but
/// one begins. Where the window has its own device, nothing is waited for: one picture at a time is
/// under way, and is brought over when it is done. What it needs is prepared by another thread, and
/// nobody else may use the renderer while the stage is busy.
class Stage {
 public:
  Stage(Renderer& renderer, const VulkanDevice& window, RenderNotes& notes);
  Stage(const Stage&) = delete;  // holds pointers to itself
  Stage& operator=(const Stage&) = delete;

  /// Replaces the scene. Throws Error where the renderer refuses it. The renderer then has the
  /// previous scene again, if there was one, and positions set in that must be set again.
  void setScene(const Scene& scene, const Scene& before);
  bool hasScene() const { return hasScene_; }

  /// Hands the session's edits to the renderer and makes it draw the picture, and the paper's where
  /// the session is divided. A variable other than radiance comes a frame later. While something is
  /// `moving`, pictures come fast: with one sample per pixel, and with coarser light where the
  /// session allows it and its transport was slow. Must not be called while busy. Throws Error
  /// where the renderer does, as does takeUp(), and can be called again.
  void draw(Session& session, int width, int height, bool moving);
  /// Whether the window has its own device.
  bool isApart() const { return apart_; }
  /// Whether draw() would block for seconds: not if the window has its own device.
  bool wouldBlock(const Session& session) const;
  /// Whether a picture is under way, done or not, that must be taken up.
  bool isUnderWay() const { return making_.valid() || (apart_ && !waiting_.empty()); }
  /// Whether that picture is not done yet, so that waiting for it would block.
  bool isBusy() const { return making_.valid() || (isUnderWay() && !watch_.isDone()); }
  /// Whether takeUp() has something to do.
  bool hasNews() const;
  /// When that picture was begun.
  std::chrono::steady_clock::time_point busySince() const { return busySince_; }
  /// Takes up a picture that is done, or what was prepared for it.
  void takeUp();
  /// Waits for everything under way.
  void finish();
  /// Waits until nobody else uses the renderer.
  void await() const;

  const DeviceImage& picture() const { return apart_ ? hostPicture_.shown() : picture_; }
  /// The paper's picture, while the session is divided.
  std::optional<DeviceImage> paper() const;
  /// Whether its light is computed more coarsely than the session says.
  bool isCoarse() const { return coarse_; }
  /// The last finished frame of the session's own method.
  const Frame& lastFrame() const { return frame_; }
  /// The variable in that frame and its values; null where only radiance was wanted.
  Aov variable() const { return variable_; }
  const Image* variableImage() const;
  std::size_t framesFinished() const { return framesFinished_; }
  /// The report of that frame, even if its scene has been replaced.
  const RenderReport& report() const { return report_; }

 private:
  /// What pictures need to be prepared, which may take seconds.
  struct Needs {
    Transport transport;
    Sum sum;
    Site site;
    int maxSurfels;
    int maxClusters;
    int shadowSize;
    Aov variable;

    bool operator==(const Needs&) const = default;
  };
  struct Waiting {
    View* view = nullptr;
    Aov variable = Aov::Radiance;
  };

  Edits handOver(Session& session);
  View& viewFor(const RenderOptions& options, const Edits& edits);
  void make(View& view, Aov variable);
  void submit(View& view, Aov variable);
  void collect();
  bool isPaper(const View& view) const { return paper_ && &view == &*paper_; }

  Renderer& renderer_;
  RenderNotes& notes_;
  const bool apart_;  // the window has its own device
  bool hasScene_ = false;
  MaterialClips materialClips_;  // of the scene that the renderer was given
  bool divided_ = false;
  View view_;
  std::optional<View> coarseView_;  // on a coarse division; none until something moves
  std::optional<View> paper_;       // by the paper's method; none until the session is divided
  DeviceImage picture_;
  DeviceImage paperPicture_;
  HostPicture hostPicture_;
  HostPicture hostPaper_;
  QueueWatch watch_;  // for the frames under way
  Frame frame_;
  RenderReport report_;
  Frame other_;  // by the paper's method
  Aov variable_ = Aov::Radiance;
  std::vector<Waiting> waiting_;  // frames under way, oldest first
  std::chrono::steady_clock::time_point busySince_;
  bool coarse_ = false;
  bool resting_ = true;  // nothing moved in the last frame
  double restMs_ = 0;    // of the last such frame that computed its light
  std::size_t restSurfels_ = 0;
  std::size_t framesFinished_ = 0;
  FrameOrder order_;
  std::optional<Needs> prepared_;  // of the last picture; none: the scene is new
  bool paperIsPrepared_ = false;
  std::future<void> making_;  // last, so that it ends before the members that it uses
};

}  // namespace opaline::app::viewer
