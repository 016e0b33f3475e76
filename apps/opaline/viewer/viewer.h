#pragma once

#include <array>
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/json.h"
#include "opaline/renderer.h"
#include "viewer/files/file_chooser.h"
#include "viewer/files/saver.h"
#include "viewer/panels/dashboard.h"
#include "viewer/panels/question.h"
#include "viewer/panels/timing_history.h"
#include "viewer/picture/overlay.h"
#include "viewer/picture/picture_input.h"
#include "viewer/picture/picture_view.h"
#include "viewer/picture/poke.h"
#include "viewer/session/loader.h"
#include "viewer/session/opening.h"
#include "viewer/session/render_notes.h"
#include "viewer/session/sequence_player.h"
#include "viewer/session/session.h"
#include "viewer/session/stage.h"
#include "viewer/session/truth_view.h"
#include "viewer/session/undo_list.h"
#include "viewer/session/viewer_state.h"
#include "viewer/window/presenter.h"
#include "viewer/window/presenting_device.h"
#include "viewer/window/user_interface.h"
#include "viewer/window/window.h"

namespace opaline::app::viewer {

/// The settings with which a window begins.
struct ViewerOptions {
  SceneOptions source;
  Prepare prepare;  ///< applied to every scene that is opened
  RendererOptions renderer;
  std::optional<std::array<int, 2>> size;  ///< of the window; none: as it was left
  std::filesystem::path configFolder;      ///< where the window's state is kept; empty: nowhere
  std::optional<std::filesystem::path> controls;  ///< receives the places of all controls
};

/// The window: takes input, passes edits to the renderer and shows its pictures.
class Viewer {
 public:
  explicit Viewer(const ViewerOptions& options);
  ~Viewer();
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  /// Runs until the window is closed. Throws Error where the device fails.
  void run();

  /// The report on the last picture, as render writes it; null where there was none.
  Json report() const;
  std::size_t validationMessages() const { return renderer_.validationMessages(); }

 private:
  using Clock = std::chrono::steady_clock;

  void takeLoaded();
  void openDropped();
  void open(const SceneOptions& asked);
  void openFile(const std::filesystem::path& file);
  void light(const std::filesystem::path& file);
  void takeFile(FileAnswer answer);
  bool leaves();
  void say(std::string_view text, bool isError = false);
  void stayAwake();
  void resize(std::optional<float> diagonalMm);
  void keepState();
  bool movesItself() const;
  bool moves() const;
  bool isIdle() const;
  void sleepUntilNeeded();
  void waitBesideDevice() const;
  void advance(double elapsed);
  void showBusiness();
  bool announce();
  void drawInterface();
  void useKeys(const std::vector<KeyPress>& presses);
  void drawDialogs();
  void followEdits();
  void requireKnownToPattern() const;
  void setGround();
  void placeBody();
  void drawPicture();
  void takeBackEdit(std::string_view error);
  void takeFinished();
  void present();
  std::vector<Caption> captions() const;
  void save();
  void followFilm();
  void startTruth();
  void saveTruth();
  void followTruth();
  void writeControls() const;

  ViewerOptions options_;
  ViewerState state_;
  Window window_;
  RenderNotes notes_;
  Renderer renderer_;
  PresentingDevice presenting_;
  Presenter presenter_;
  UserInterface interface_;
  PictureView view_;
  Dashboard dashboard_;
  Stage stage_;
  Loader loader_;
  FileChooser files_;
  Question question_;
  bool resizing_ = false;  // the same model is being loaded at another size
  Session session_;
  UndoList undo_;
  bool reaching_ = false;  // the session is still on the way to the list's present state
  PictureInput input_;
  Poke poke_;
  SequencePlayer sequence_;
  Saver saver_;
  TruthView truth_;
  TimingHistory history_;

  Area drawn_;                   // area of the last picture
  bool rough_ = false;           // the last picture was drawn for speed
  bool exposing_ = false;        // the picture under way needs a new exposure
  bool busyShown_ = false;       // a sign says that pictures are slow
  bool announced_ = false;       // a sign says that the next task takes a moment
  int awake_ = 0;                // frames of the interface to draw before sleeping
  std::size_t framesTaken_ = 0;  // of the stage's, in history_
  std::size_t inputsDrawn_ = 0;  // uses of keys, buttons and wheel
  Clock::time_point last_ = Clock::now();
  bool mayLeave_ = false;          // even if work is under way
  std::optional<Caption> notice_;  // until the next key or mouse press
};

}  // namespace opaline::app::viewer
