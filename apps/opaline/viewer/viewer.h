#pragma once

#include <array>
#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "json.h"
#include "opaline/renderer.h"
#include "viewer/host_picture.h"
#include "viewer/loader.h"
#include "viewer/picture_input.h"
#include "viewer/picture_painter.h"
#include "viewer/poke.h"
#include "viewer/presenter.h"
#include "viewer/saver.h"
#include "viewer/session.h"
#include "viewer/stage.h"
#include "viewer/timing_history.h"
#include "viewer/truth_view.h"
#include "viewer/user_interface.h"
#include "viewer/viewer_state.h"
#include "viewer/window.h"

namespace opaline::app::viewer {

/// What a window begins with.
struct ViewerOptions {
  SceneOptions source;
  /// Brings what else was asked for on the command line into what was loaded. May throw.
  std::function<void(LoadedScene&, Session&)> prepare;
  RendererOptions renderer;
  std::optional<std::array<int, 2>> size;  ///< of the window; else as it was left
  std::filesystem::path configFolder;      ///< where the window's state is kept; empty: nowhere
  std::optional<std::filesystem::path> controls;  ///< gets the places of all controls
};

/// The window: takes input, brings edits to the renderer and its pictures to the screen.
class Viewer {
 public:
  explicit Viewer(const ViewerOptions& options);
  ~Viewer();
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  /// Until the window is closed. Throws Error where the device fails.
  void run();

  /// Of the last picture, as render reports it; null where there was none.
  Json report() const;
  std::size_t validationMessages() const { return renderer_.validationMessages(); }

 private:
  using Clock = std::chrono::steady_clock;

  void takeLoaded();
  void openDropped();
  void open(const SceneOptions& asked);
  void resize(float diagonalMm);
  void keepState();
  void sleepUntilNeeded();
  void advance(double seconds);
  void layOut();
  void drawPanels();
  void useKeys();
  void drawInterface();
  void drawPicture();
  void takeFinished();
  void drawShown(VkCommandBuffer commands);
  void present();
  void save();
  void followTruth();
  void writeControls() const;

  ViewerOptions options_;
  ViewerState state_;
  Window window_;
  Renderer renderer_;
  Presenter presenter_;
  UserInterface interface_;
  PicturePainter painter_;
  Stage stage_;
  HostPicture variable_;  // that is shown instead of radiance
  Aov variableShown_ = Aov::Radiance;
  Loader loader_;
  bool resizing_ = false;  // what is being loaded is the same model at another size
  Session session_;
  PictureInput input_;
  Poke poke_;
  Saver saver_;
  TruthView truth_;
  TimingHistory history_;

  Area area_;   // of the picture
  Area drawn_;  // that the last picture was drawn for
  bool panels_ = true;
  bool keys_ = false;
  bool rough_ = false;           // the last picture was drawn for speed
  int awake_ = 0;                // frames of the interface to draw before sleeping
  std::size_t framesTaken_ = 0;  // of the stage's, into history_
  Clock::time_point last_ = Clock::now();
  std::string message_;
  bool failed_ = false;  // message_ is an error
};

}  // namespace opaline::app::viewer
