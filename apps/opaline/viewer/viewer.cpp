#include "viewer/viewer.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/file.h"
#include "framing.h"
#include "json.h"
#include "opaline/error.h"
#include "render_report.h"
#include "viewer/controls.h"
#include "viewer/orbit.h"

namespace opaline::app::viewer {

namespace {

// Frames that Dear ImGui needs after an event until everything that follows from it is drawn.
constexpr int framesAfterEvent = 3;

RendererOptions forWindows(RendererOptions options) {
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
      renderer_(forWindows(options.renderer)),
      presenting_(renderer_.vulkanDevice()),
      presenter_(presenting_.device(), window_),
      interface_(presenting_.device(), presenter_, window_),
      view_(presenting_.device(), presenter_.renderPass()),
      dashboard_(state_.panels),
      stage_(renderer_, presenting_.device()),
      loader_([] { Window::wake(); }),
      poke_(renderer_),
      sequence_(renderer_),
      saver_(renderer_),
      truth_(presenting_.device()) {
  session_.gizmos = state_.handles;
  session_.scaleBar = state_.scaleBar;
  controls::setOpenSections(state_.openSections);
  open(options_.source);
}

Viewer::~Viewer() = default;

void Viewer::keepState() {
  const auto [width, height] = window_.size();
  // A window that is minimised, or as large as the screen allows, says nothing.
  if (width > 0 && height > 0) {
    state_.width = width;
    state_.height = height;
  }
  state_.handles = session_.gizmos;
  state_.scaleBar = session_.scaleBar;
  state_.panels = dashboard_.panels();
  state_.openSections = controls::openSections();
  writeState(options_.configFolder, state_);
}

void Viewer::open(const SceneOptions& asked) {
  notice_.reset();
  resizing_ = false;
  loader_.start(asked);
}

void Viewer::say(std::string text, bool isError) {
  notice_ = {std::move(text), isError};
  awake_ = std::max(awake_, framesAfterEvent);
}

void Viewer::resize(float diagonalMm) {
  SceneOptions asked = session_.asked;
  asked.setDiagonalMm(diagonalMm);
  open(asked);
  resizing_ = true;
}

void Viewer::openDropped() {
  for (const std::filesystem::path& file : window_.takeDropped()) {
    if (!isEnvironment(file)) {
      SceneOptions asked;
      asked.setFile(file);
      open(asked);
      continue;
    }
    try {
      takeEnvironment(file, session_);
    } catch (const std::exception& error) {
      say(error.what(), true);
    }
  }
}

void Viewer::takeLoaded() {
  const Area& area = dashboard_.area();
  if (area.empty() || stage_.isBusy()) return;
  std::optional<Loader::Result> result = loader_.take();
  if (!result) return;
  if (!result->loaded) return say(result->error, true);
  try {
    Session made = resizing_ ? resized(session_, std::move(*result))
                             : opened(std::move(*result), options_.prepare);
    if (!resizing_) {
      showAll(made.scene, {made.options.clip, area.aspect(), made.sequence.get(),
                           someMoments(lengthOfMotion(made), made.sequence.get())});
    }
    made.gizmos = session_.gizmos;
    made.scaleBar = session_.scaleBar;
    poke_.end();
    saver_.cancelFilm();
    stage_.setScene(made.scene);
    session_ = std::move(made);
    history_.clear();
    framesTaken_ = stage_.framesFinished();
    window_.setTitle(fmt::format("{} - Opaline", session_.name));
  } catch (const Error& error) {
    say(error.what(), true);
  }
}

bool Viewer::movesItself() const {
  return session_.playback.playing || session_.playback.turntable || poke_.moves();
}

bool Viewer::isIdle() const {
  return awake_ == 0 && !movesItself() && !saver_.filming() && !session_.edits.any() &&
         !stage_.isBusy() && !announced_;
}

// By itself or by the hand.
bool Viewer::moves() const {
  const bool sliding = ImGui::IsAnyItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left);
  return movesItself() || input_.dragging() || sliding;
}

void Viewer::sleepUntilNeeded() {
  if (isIdle()) {
    constexpr double betweenLooks = 0.25;
    Window::wait(truth_.running() ? betweenLooks : 0);
    awake_ = framesAfterEvent;
    last_ = Clock::now();  // what slept did not play
  } else {
    if (stage_.isBusy()) {
      waitBesideDevice();
    } else {
      Window::poll();
    }
    awake_ = std::max(0, awake_ - 1);
  }
  if (window_.takeRefresh()) awake_ = framesAfterEvent;
}

// Until the picture under way is done, or long enough that the controls are drawn again; drawing
// them more often would keep the device from it.
void Viewer::waitBesideDevice() const {
  constexpr double betweenLooks = 0.005;
  constexpr std::chrono::milliseconds betweenDrawings(50);
  do {
    Window::wait(betweenLooks);
  } while (!stage_.isReady() && Clock::now() - last_ < betweenDrawings);
}

void Viewer::advance(double elapsed) {
  poke_.advance(elapsed);
  // What took long did not play: time goes on from what was seen.
  constexpr double longest = 0.1;
  const double seconds = std::min(elapsed, longest);
  Playback& playback = session_.playback;
  if (playback.playing) {
    const auto length = static_cast<double>(playback.lengthSeconds);
    double at = session_.options.seconds + static_cast<double>(playback.speed) * seconds;
    if (at >= length && !playback.loop) {
      at = length;
      playback.playing = false;
    }
    session_.options.seconds = at >= length && playback.loop ? std::fmod(at, length) : at;
    session_.edits.picture = true;
  }
  if (playback.turntable) {
    constexpr float radiansPerSecond = 0.5F;
    orbit(session_.scene.camera, radiansPerSecond * static_cast<float>(seconds), 0);
    session_.edits.camera = true;
  }
}

void Viewer::drawInterface() {
  inputsDrawn_ = window_.inputs();
  interface_.begin();
  const ImVec2 mouseMoved = ImGui::GetIO().MouseDelta;
  if (mouseMoved.x != 0 || mouseMoved.y != 0) awake_ = framesAfterEvent;
  controls::beginFrame();
  dashboard_.layOut();
  dashboard_.useKeys(window_.takeKeys(), window_, session_, stage_.hasScene());
  if (stage_.hasScene()) {
    input_.useMouse(session_, dashboard_.area(), poke_);
    dashboard_.drawPanels(session_, truth_, history_, saver_);
    if (session_.wantedDiagonalMm) resize(*std::exchange(session_.wantedDiagonalMm, std::nullopt));
    dashboard_.drawOverPicture(session_, truth_, input_.handles(), captions());
  }
  dashboard_.drawKeyList();
  drawCaptions(captions(), dashboard_.area());
  interface_.end();
}

void Viewer::placeBody() {
  if (poke_.holdsBody() || saver_.filming()) return sequence_.forget();
  try {
    sequence_.place(session_);
  } catch (const std::exception& error) {
    session_.playback.playing = false;
    say(error.what(), true);
  }
}

void Viewer::drawPicture() {
  const Area& area = dashboard_.area();
  if (!stage_.hasScene() || stage_.isBusy()) return;
  if (poke_.step()) session_.edits.picture = true;
  if (area.empty()) return;
  const bool moving = moves();
  const bool resized = area.width != drawn_.width || area.height != drawn_.height;
  // What was drawn for speed is drawn well once nothing moves.
  if (!session_.edits.any() && !resized && !(rough_ && !moving)) return;
  rough_ = moving;
  drawn_ = area;
  placeBody();
  if (session_.edits.lighting) exposeByLight(session_);
  stage_.draw(session_, area.width, area.height, moving);
  awake_ = std::max(awake_, 1);
  if (!moving && !stage_.isBusy()) stage_.finish();
}

void Viewer::takeFinished() {
  if (framesTaken_ == stage_.framesFinished()) return;
  framesTaken_ = stage_.framesFinished();
  history_.add(stage_.lastFrame());
  session_.report = stage_.report();
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

// A sign that stays while one slow picture follows the other, and never comes where they are quick.
void Viewer::showBusiness() {
  constexpr std::chrono::milliseconds soon(100);
  if (!stage_.isBusy()) {
    if (!session_.edits.any()) busyShown_ = false;
    return;
  }
  busyShown_ = busyShown_ || Clock::now() - stage_.busySince() > soon;
}

// True a second time, when the window has been drawn with a sign that it will take a moment.
bool Viewer::announce() {
  announced_ = !announced_;
  return !announced_;
}

std::vector<Caption> Viewer::captions() const {
  std::vector<Caption> captions;
  if (notice_) captions.push_back(*notice_);
  if (loader_.busy()) captions.push_back({fmt::format("loading {}", loader_.name())});
  if (saver_.filming()) {
    captions.push_back({fmt::format("filming, {:.0f} %", 100 * saver_.progress())});
  }
  if (stage_.isCoarse()) captions.push_back({"light is coarser while it moves"});
  if (announced_) captions.push_back({"one moment"});
  if (!announced_ && busyShown_) captions.push_back({"rendering"});
  return captions;
}

void Viewer::save() {
  if (session_.wanted != Save::Nothing && (stage_.isBusy() || !announce())) return;
  const Save wanted = std::exchange(session_.wanted, Save::Nothing);
  if (wanted == Save::Nothing && !saver_.filming()) return;
  if (wanted == Save::Film) {
    poke_.end();
    session_.playback.playing = false;
  }
  try {
    stage_.finish();
    const Area& area = dashboard_.area();
    if (const auto done = saver_.save(wanted, session_, area.width, area.height)) say(*done);
    if (!saver_.filming()) return;
    if (const auto done = saver_.step()) {
      say(*done);
      session_.edits.picture = true;
    }
  } catch (const std::exception& error) {
    say(error.what(), true);
  }
}

void Viewer::startTruth() {
  const TruthOrder::Method method = *std::exchange(session_.wantedTruth, std::nullopt);
  const Area& area = dashboard_.area();
  if (!stage_.hasScene() || area.empty()) return;
  stage_.finish();
  poke_.end();
  placeBody();
  try {
    truth_.start(session_, renderer_, method, area.width, area.height);
  } catch (const Error& error) {
    say(error.what(), true);
  }
  session_.edits.picture = true;
}

void Viewer::saveTruth() {
  const std::optional<TruthFile> what = std::exchange(session_.wantedTruthFile, std::nullopt);
  if (!what) return;
  const char* ending = *what == TruthFile::HeatMap ? "_heat_map.png"
                       : *what == TruthFile::Exr   ? "_truth.exr"
                                                   : "_truth.png";
  try {
    say(truth_.save(*what, session_.saveName + ending, session_.tone));
  } catch (const std::exception& error) {
    say(error.what(), true);
  }
}

void Viewer::followTruth() {
  if (std::exchange(session_.cancelTruth, false)) truth_.cancel();
  if (session_.wantedTruth && !stage_.isBusy() && announce()) startTruth();
  saveTruth();
  if (truth_.update()) awake_ = std::max(awake_, framesAfterEvent);
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
  core::writeWhole(*options_.controls, toText(json));
}

Json Viewer::report() const {
  if (!session_.report) return nullptr;
  Json json = renderReportJson(*session_.report, session_.options, {});
  json["exposure_stops"] = shortJson(session_.tone.exposureStops);
  return json;
}

void Viewer::run() {
  while (!window_.wantsToClose()) {
    sleepUntilNeeded();
    if (window_.takePress()) notice_.reset();
    openDropped();
    takeLoaded();
    const Clock::time_point now = Clock::now();
    advance(std::chrono::duration<double>(now - last_).count());
    last_ = now;
    stage_.takeUp();
    showBusiness();
    drawInterface();
    save();
    followTruth();
    drawPicture();
    takeFinished();
    present();
    if (options_.controls) writeControls();
  }
  stage_.finish();
  presenter_.waitIdle();
  keepState();
}

}  // namespace opaline::app::viewer
