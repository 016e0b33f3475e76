#include "viewer/viewer.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

#include <GLFW/glfw3.h>

#include "cli/field_names.h"
#include "cli/json.h"
#include "film/render_report.h"
#include "opaline/error.h"
#include "opaline/file.h"
#include "viewer/panels/controls.h"
#include "viewer/session/playback.h"
#include "viewer/session/work_under_way.h"

namespace opaline::app::viewer {

namespace {

// Frames that Dear ImGui needs after an event until all its effects are drawn.
constexpr int framesAfterEvent = 3;

RendererOptions forWindows(RendererOptions options, RenderNotes& notes) {
  options.log = notes.taker(std::move(options.log));
  options.instanceExtensions = Window::instanceExtensions();
  options.deviceExtensions = Window::deviceExtensions();
  return options;
}

}  // namespace

Viewer::Viewer(const ViewerOptions& options)
    : options_(options),
      state_(readState(options.configFolder)),
      window_(options.size ? (*options.size)[0] : state_.width,
              options.size ? (*options.size)[1] : state_.height, "Opaline"),
      renderer_(forWindows(options.renderer, notes_)),
      presenting_(renderer_.vulkanDevice()),
      presenter_(presenting_.device(), window_),
      interface_(presenting_.device(), presenter_, window_),
      view_(presenting_.device(), presenter_.renderPass()),
      dashboard_(state_.panels),
      stage_(renderer_, presenting_.device(), notes_),
      loader_([] { Window::wake(); }),
      files_(state_.openFolder),
      poke_(renderer_),
      sequence_(renderer_),
      saver_(renderer_, stage_.isApart()),
      truth_(presenting_.device()) {
  session_.gizmos = state_.handles;
  session_.scaleBar = state_.scaleBar;
  controls::setOpenSections(state_.openSections);
  open(options_.source);
}

Viewer::~Viewer() {
  stage_.await();  // others need the renderer to be destroyed
}

void Viewer::keepState() {
  const auto [width, height] = window_.size();
  // A minimised or maximised window has no size worth keeping.
  if (width > 0 && height > 0) {
    state_.width = width;
    state_.height = height;
  }
  state_.handles = session_.gizmos;
  state_.scaleBar = session_.scaleBar;
  state_.panels = dashboard_.panels();
  state_.openSections = controls::openSections();
  state_.openFolder = files_.openFolder();
  writeState(options_.configFolder, state_);
}

void Viewer::open(const SceneOptions& asked) {
  resizing_ = false;
  loader_.start(asked);
}

void Viewer::say(std::string_view text, bool isError) {
  notice_ = {withOptionNames(text), isError};
  stayAwake();
}

void Viewer::stayAwake() {
  awake_ = std::max(awake_, framesAfterEvent);
}

void Viewer::resize(std::optional<float> diagonalMm) {
  SceneOptions asked = session_.asked;
  asked.setDiagonalMm(diagonalMm);
  open(asked);
  resizing_ = true;
}

// Whether the window closes. Asks first if that would lose work.
bool Viewer::leaves() {
  if (!window_.wantsToClose()) return false;
  const std::optional<std::string> lost = workUnderWay(saver_, truth_);
  if (!lost || mayLeave_) return true;
  window_.stay();
  files_.close();
  stayAwake();
  question_.ask({fmt::format("{} Leave anyway?", *lost), "stop and leave", "go on"}, [this] {
    mayLeave_ = true;
    window_.close();
  });
  return false;
}

bool Viewer::movesItself() const {
  return session_.playback.playing || session_.playback.turntable || poke_.moves();
}

bool Viewer::isIdle() const {
  return awake_ == 0 && !window_.hasInputs() && !movesItself() && !saver_.keepsRenderer() &&
         !session_.edits.any() && !stage_.isUnderWay() && !announced_;
}

// Whether something moves, by itself or by hand.
bool Viewer::moves() const {
  const bool sliding = ImGui::IsAnyItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left);
  return movesItself() || input_.dragging() || sliding;
}

void Viewer::sleepUntilNeeded() {
  if (isIdle()) {
    constexpr double betweenLooks = 0.25;
    Window::wait(truth_.running() || files_.isWaiting() ? betweenLooks : 0);
    awake_ = framesAfterEvent;
    last_ = Clock::now();  // the animation does not play while the window sleeps
  } else {
    if ((stage_.isUnderWay() || saver_.isBusy()) && !window_.hasInputs()) {
      waitBesideDevice();
    } else {
      Window::poll();
    }
    awake_ = std::max(0, awake_ - 1);
  }
  if (window_.takeRefresh() || window_.hasInputs()) awake_ = framesAfterEvent;
}

// Waits until the picture or the film's frame under way is done, or long enough that the controls
// must be drawn again. Drawing them more often would slow the device down.
void Viewer::waitBesideDevice() const {
  constexpr double betweenLooks = 0.005;
  constexpr std::chrono::milliseconds betweenDrawings(80);
  const auto isWorking = [this] {
    return saver_.isBusy() || (stage_.isUnderWay() && !stage_.hasNews());
  };
  do {
    Window::wait(betweenLooks);
  } while (isWorking() && Clock::now() - last_ < betweenDrawings);
}

void Viewer::advance(double elapsed) {
  poke_.advance(elapsed);
  // After a long frame the animation continues from what was seen.
  constexpr double longest = 0.1;
  playOn(std::min(elapsed, longest), session_);
}

void Viewer::drawInterface() {
  const std::vector<Input> inputs = window_.takeInputs();
  const bool anyPress =
      std::any_of(inputs.begin(), inputs.end(), [](const Input& input) { return input.isPress(); });
  // Without a scene, nothing else says why there is none.
  if (anyPress && stage_.hasScene()) notice_.reset();
  inputsDrawn_ += static_cast<std::size_t>(std::count_if(
      inputs.begin(), inputs.end(), [](const Input& input) { return input.isUse(); }));
  interface_.begin(inputs);
  const ImVec2 mouseMoved = ImGui::GetIO().MouseDelta;
  if (mouseMoved.x != 0 || mouseMoved.y != 0) awake_ = framesAfterEvent;
  controls::beginFrame();
  dashboard_.layOut(session_);
  useKeys(keyPressesOf(inputs));
  if (stage_.hasScene()) {
    if (!saver_.filming()) input_.useMouse(session_, dashboard_.area(), poke_);
  }
  dashboard_.drawPanels(session_, stage_.hasScene(), truth_, history_, saver_, undo_);
  if (stage_.hasScene()) {
    if (session_.wantedDiagonalMm) resize(*std::exchange(session_.wantedDiagonalMm, std::nullopt));
    dashboard_.drawOverPicture(session_, truth_, input_.handles(), captions());
  }
  dashboard_.drawKeyList();
  drawDialogs();
  drawCaptions(captions(), dashboard_.area());
  interface_.end();
}

void Viewer::useKeys(const std::vector<KeyPress>& presses) {
  for (const KeyPress& press : presses) {
    if (press.control && press.key == GLFW_KEY_Q) window_.close();
  }
  if (question_.isOpen()) return question_.useKeys(presses);
  if (files_.isModal()) return files_.useKeys(presses);
  dashboard_.useKeys(presses, session_, stage_.hasScene(), saver_.filming());
}

void Viewer::drawDialogs() {
  if (!session_.refused.empty()) say(std::exchange(session_.refused, {}));
  if (const auto use = std::exchange(session_.wantedFile, std::nullopt)) {
    files_.ask(*use, session_.saveName);
  }
  if (std::optional<FileAnswer> answer = files_.draw()) takeFile(std::move(*answer));
  question_.draw();
}

// An edit becomes a step of the list once the user lets go. A step back or forward takes effect at
// once, except for the model's size, which needs loading first.
void Viewer::followEdits() {
  const int steps = std::exchange(session_.wantedSteps, 0);
  if (undo_.isEmpty() || ImGui::IsAnyItemActive() || input_.dragging()) return;
  const bool loading = loader_.busy();
  if (!reaching_ && !(loading && resizing_) && !isStateOf(undo_.present(), session_)) {
    undo_.add(editStateOf(session_));
  }
  if (steps != 0) {
    steps < 0 ? undo_.undo() : undo_.redo();
    reaching_ = true;
  }
  if (!reaching_ || loading) return;
  if (!hasSizeOf(undo_.present(), session_)) return resize(undo_.present().diagonalMm);
  reaching_ = false;
  restore(undo_.present(), session_);
}

void Viewer::placeBody() {
  if (poke_.holdsBody() || saver_.keepsRenderer()) return sequence_.forget();
  try {
    sequence_.place(session_);
  } catch (const std::exception& error) {
    session_.playback.playing = false;
    say(error.what(), true);
  }
}

void Viewer::drawPicture() {
  const Area& area = dashboard_.area();
  // A film shows the scene as it was when the film began, so edits wait for its end.
  if (!stage_.hasScene() || stage_.isBusy() || saver_.keepsRenderer()) return;
  if (poke_.step()) {
    session_.edits.picture = true;
    truth_.noteEdit();
  }
  if (area.empty()) return;
  const bool moving = moves();
  const bool resized = area.width != drawn_.width || area.height != drawn_.height;
  // A new ground means a new scene, so it waits until the mouse lets go.
  if (session_.edits.ground && ImGui::IsAnyItemActive()) return;
  // A picture drawn for speed is drawn again in full once nothing moves.
  if (!session_.edits.any() && !resized && !(rough_ && !moving)) return;
  if (stage_.wouldBlock(session_) && !announce()) return;
  rough_ = moving;
  drawn_ = area;
  exposing_ = exposing_ || session_.edits.lighting;
  awake_ = std::max(awake_, 1);
  try {
    requireKnownToPattern();
    if (session_.edits.ground) setGround();
    placeBody();
    truth_.follow(session_);
    undo_.markTried();
    stage_.draw(session_, area.width, area.height, moving);
    if (stage_.isBusy()) return;
    if (!moving) stage_.finish();
    undo_.markSound();
  } catch (const Error& error) {
    takeBackEdit(error.what());
  }
}

void Viewer::requireKnownToPattern() const {
  if (!session_.divided && session_.options.sum != Sum::Pattern) return;
  const std::string complaint = complaintAboutPattern(session_.scene);
  if (!complaint.empty()) throw UsageError(complaint);
}

// The scene is prepared again. If that fails, it is left without a ground and the edit is taken
// back.
void Viewer::setGround() {
  Scene without = session_.scene;
  removeGround(without);
  poke_.end();
  sequence_.forget();
  stage_.setScene(session_.scene, without);
}

// Takes an edit back that cannot be rendered, for example for lack of memory. Other failures are
// not retried automatically.
void Viewer::takeBackEdit(std::string_view error) {
  say(error, true);
  session_.edits = {};
  session_.edits.material.assign(session_.scene.objects.size(), false);
  if (undo_.isSound() && isStateOf(undo_.present(), session_)) return;
  reaching_ = undo_.takeBack();
  session_.edits.camera = reaching_;
}

void Viewer::takeFinished() {
  try {
    stage_.takeUp();
  } catch (const Error& error) {
    return takeBackEdit(error.what());
  }
  if (framesTaken_ == stage_.framesFinished()) return;
  framesTaken_ = stage_.framesFinished();
  undo_.markSound();
  // The exposure changes together with the picture of the light for which it is meant.
  if (std::exchange(exposing_, false)) exposeByLight(session_);
  history_.add(stage_.lastFrame());
  session_.report = stage_.report();
  session_.renderNotes = notes_.all();
  if (stage_.lastFrame().provisional) session_.edits.picture = true;
  awake_ = std::max(awake_, 1);
  view_.take(stage_, session_);
}

void Viewer::present() {
  const std::optional<VkCommandBuffer> commands = presenter_.begin();
  if (!commands) return;
  const Area& area = dashboard_.area();
  if (stage_.hasScene() && !area.empty()) view_.draw(*commands, session_, stage_, truth_, area);
  interface_.draw(*commands);
  presenter_.end();
}

// The sign stays between slow pictures, and does not appear where they are quick.
void Viewer::showBusiness() {
  constexpr std::chrono::milliseconds soon(100);
  // A scene loaded meanwhile no longer wants what was announced.
  if (session_.wanted == Save::Nothing && !session_.wantedTruth && !stage_.wouldBlock(session_))
    announced_ = false;
  if (!stage_.isUnderWay() && !session_.edits.any()) busyShown_ = false;
  if (!stage_.isBusy()) return;
  busyShown_ = busyShown_ || Clock::now() - stage_.busySince() > soon;
}

std::vector<Caption> Viewer::captions() const {
  std::vector<Caption> captions;
  if (notice_) captions.push_back(*notice_);
  if (loader_.busy()) captions.push_back({fmt::format("loading {}", loader_.name())});
  if (saver_.filming()) {
    captions.push_back({fmt::format("filming, {:.0f} %; the picture waits for the film's end",
                                    100 * saver_.progress())});
  }
  if (files_.isWaiting()) captions.push_back({"a file is being chosen in another window"});
  if (stage_.isCoarse()) captions.push_back({"light is coarser while it moves"});
  if (announced_) captions.push_back({"one moment"});
  if (!announced_ && busyShown_) captions.push_back({"rendering"});
  return captions;
}

void Viewer::writeControls() const {
  Json places = Json::object();
  for (const controls::Place& place : controls::places()) {
    places[place.name] = {place.x, place.y, place.width, place.height};
  }
  const Area& area = dashboard_.area();
  const std::vector<Caption> said = captions();
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const Json json{{"picture", {area.x, area.y, area.width, area.height}},
                  {"controls", std::move(places)},
                  {"message", said.empty() ? "" : said.front().text},
                  {"frames", stage_.framesFinished()},
                  {"inputs", inputsDrawn_},
                  {"mouse", {mouse.x, mouse.y}},
                  {"idle", isIdle() && !loader_.busy()},
                  {"truth", truth_.running()      ? truth_.progress()
                            : truth_.hasPicture() ? 1
                                                  : 0}};
  writeWhole(*options_.controls, toText(json));
}

Json Viewer::report() const {
  if (!session_.report) return nullptr;
  Json json = renderReportJson(*session_.report, session_.options, {});
  json["exposure_stops"] = shortJson(session_.tone.exposureStops);
  return json;
}

void Viewer::run() {
  while (!leaves()) {
    sleepUntilNeeded();
    openDropped();
    takeLoaded();
    const Clock::time_point now = Clock::now();
    advance(std::chrono::duration<double>(now - last_).count());
    last_ = now;
    showBusiness();
    drawInterface();
    followEdits();
    save();
    followFilm();
    followTruth();
    drawPicture();
    takeFinished();
    present();
    if (options_.controls) writeControls();
  }
  // What is under way may take seconds, of which nobody must see anything.
  keepState();
  window_.hide();
  stage_.finish();
  presenter_.waitIdle();
}

}  // namespace opaline::app::viewer
