#include "viewer/viewer.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <GLFW/glfw3.h>

#include "core/file.h"
#include "json.h"
#include "motion_options.h"
#include "opaline/error.h"
#include "output.h"
#include "paths.h"
#include "picture_options.h"
#include "render_report.h"
#include "scene/environment_file.h"
#include "viewer/controls.h"
#include "viewer/orbit.h"
#include "viewer/overlay.h"
#include "viewer/panels/panels.h"
#include "viewer/variable_display.h"

namespace opaline::app::viewer {

namespace {

// Frames that Dear ImGui needs after an event until everything that follows from it is drawn.
constexpr int framesAfterEvent = 3;

RendererOptions forWindows(RendererOptions options) {
  options.instanceExtensions = Window::instanceExtensions();
  options.deviceExtensions = Window::deviceExtensions();
  return options;
}

// A light at the same place of a body that has become so many times as large, as bright on it.
PointLight scaled(PointLight light, float factor) {
  for (float& component : light.positionMm) component *= factor;
  for (float& channel : light.intensity) channel *= factor * factor;
  return light;
}

// What was edited, on the same model at another size.
void takeEdits(const Session& edited, Session& loaded) {
  const float factor = diagonalMm(loaded.scene) / edited.diagonalMm;
  const Scene& from = edited.scene;
  Scene& to = loaded.scene;
  for (std::size_t i = 0; i < to.objects.size() && i < from.objects.size(); ++i) {
    to.objects[i].medium = from.objects[i].medium;
  }
  to.lighting = from.lighting;
  for (PointLight& light : to.lighting.points) light = scaled(light, factor);
  to.camera = from.camera;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    to.camera.positionMm[axis] *= factor;
    to.camera.targetMm[axis] *= factor;
  }
  to.deformers = from.deformers;
  loaded.source.environment = edited.source.environment;
  loaded.options = edited.options;
  loaded.tone = edited.tone;
  loaded.playback = edited.playback;
  loaded.divided = edited.divided;
  loaded.divider = edited.divider;
  loaded.aov = edited.aov;
  loaded.surfelIndex = edited.surfelIndex;
  loaded.treeLevel = edited.treeLevel;
  loaded.object = edited.object;
}

// The largest area of a picture's shape within another.
Area fitted(const Area& area, int width, int height) {
  const double scale =
      std::min(static_cast<double>(area.width) / width, static_cast<double>(area.height) / height);
  const int w = std::max(1, static_cast<int>(scale * width));
  const int h = std::max(1, static_cast<int>(scale * height));
  return {area.x + (area.width - w) / 2, area.y + (area.height - h) / 2, w, h};
}

bool isEnvironment(const std::filesystem::path& file) {
  const std::string extension = extensionOf(file);
  return extension == ".hdr" || extension == ".exr";
}

}  // namespace

Viewer::Viewer(const ViewerOptions& options)
    : options_(options),
      state_(readState(options.configFolder)),
      window_(options.size ? (*options.size)[0] : state_.width,
              options.size ? (*options.size)[1] : state_.height, "Opaline"),
      renderer_(forWindows(options.renderer)),
      presenter_(renderer_.vulkanDevice(), window_),
      interface_(renderer_.vulkanDevice(), presenter_, window_),
      painter_(renderer_.vulkanDevice(), presenter_.renderPass()),
      stage_(renderer_),
      variable_(renderer_.vulkanDevice()),
      loader_([] { Window::wake(); }),
      poke_(renderer_),
      saver_(renderer_),
      truth_(renderer_.vulkanDevice()) {
  session_.gizmos = state_.handles;
  session_.scaleBar = state_.scaleBar;
  panels_ = state_.panels;
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
  state_.panels = panels_;
  state_.openSections = controls::openSections();
  writeState(options_.configFolder, state_);
}

void Viewer::open(const SceneOptions& asked) {
  message_ = fmt::format("loading {}", asked.name());
  failed_ = false;
  resizing_ = false;
  loader_.start(asked);
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
      const scene::EnvironmentFile dropped{std::filesystem::absolute(file)};
      session_.scene.lighting.environment = scene::readEnvironment(dropped);
      session_.environment = session_.scene.lighting.environment;
      session_.source.environment = dropped;
      session_.edits.lighting = true;
    } catch (const std::exception& error) {
      message_ = error.what();
      failed_ = true;
    }
  }
}

void Viewer::takeLoaded() {
  std::optional<Loader::Result> result = loader_.take();
  if (!result) return;
  message_ = result->error;
  failed_ = !message_.empty();
  if (failed_) return;
  try {
    LoadedScene& loaded = *result->loaded;
    Session made;
    made.asked = result->source;
    made.name = result->source.name();
    made.notes = std::move(result->notes);
    made.gizmos = session_.gizmos;
    made.scaleBar = session_.scaleBar;
    if (options_.prepare) {
      std::exchange(options_.prepare, {})(loaded, made);  // it is about the first scene
    } else {
      made.options = optionsOf(loaded.settings);
      made.tone = toneOf(loaded.settings);
    }
    if (!made.tone.background) made.tone.background = Rgb{0.03F, 0.03F, 0.035F};
    made.scene = std::move(loaded.scene);
    made.source = std::move(loaded.source);
    if (resizing_) takeEdits(session_, made);
    if (const auto& from = made.source.environment) {
      made.environment = scene::readEnvironment({from->file, from->intensity});
    }
    made.diagonalMm = diagonalMm(made.scene);
    if (!resizing_) {
      made.playback.lengthSeconds = lengthOfMotion(made.scene, made.options.clip);
      made.playback.playing = moves(made.scene, made.options.clip) && made.options.seconds == 0;
    }
    made.edits.medium.assign(made.scene.objects.size(), false);
    made.edits.picture = true;
    poke_.end();
    saver_.cancelFilm();
    made.saveName = made.name;
    stage_.setScene(made.scene);
    session_ = std::move(made);
    history_.clear();
    framesTaken_ = stage_.framesFinished();
    window_.setTitle(fmt::format("{} - Opaline", session_.name));
  } catch (const Error& error) {
    message_ = error.what();
    failed_ = true;
  }
}

void Viewer::sleepUntilNeeded() {
  const bool moving =
      session_.playback.playing || session_.playback.turntable || saver_.filming() || poke_.moves();
  if (moving || session_.edits.any() || awake_ > 0) {
    Window::poll();
    awake_ = std::max(0, awake_ - 1);
  } else {
    constexpr double betweenLooks = 0.25;
    Window::wait(truth_.running() ? betweenLooks : 0);
    awake_ = framesAfterEvent;
    last_ = Clock::now();                    // what slept did not play
    if (options_.controls) writeControls();  // whoever drives the window sees that it is awake
  }
  if (window_.takeRefresh()) awake_ = framesAfterEvent;
  const ImGuiIO& io = ImGui::GetIO();
  if (io.MouseDelta.x != 0 || io.MouseDelta.y != 0) awake_ = framesAfterEvent;
}

void Viewer::advance(double seconds) {
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
  if (poke_.step(seconds)) session_.edits.picture = true;
}

void Viewer::layOut() {
  const ImGuiIO& io = ImGui::GetIO();
  const auto width = static_cast<int>(io.DisplaySize.x);
  const auto height = static_cast<int>(io.DisplaySize.y);
  const int panel = panels_ ? std::min(static_cast<int>(24 * ImGui::GetFontSize()), width / 2) : 0;
  area_ = {0, 0, width - panel, height};
}

void Viewer::drawPanels() {
  const ImGuiIO& io = ImGui::GetIO();
  ImGui::SetNextWindowPos({static_cast<float>(area_.width), 0});
  ImGui::SetNextWindowSize({io.DisplaySize.x - static_cast<float>(area_.width), io.DisplaySize.y});
  constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
  ImGui::Begin("panels", nullptr, flags);
  ImGui::Text("%s", session_.name.c_str());
  ImGui::SameLine();
  ImGui::TextDisabled("? lists the keys");
  for (const std::string& note : session_.notes) ImGui::TextWrapped("%s", note.c_str());
  drawMediumPanel(session_);
  if (session_.wantedDiagonalMm) resize(*std::exchange(session_.wantedDiagonalMm, std::nullopt));
  drawLightPanel(session_);
  drawMethodPanel(session_);
  drawMotionPanel(session_);
  drawTruthPanel(session_, truth_);
  drawViewPanel(session_);
  drawTimePanel(session_, history_);
  drawSavePanel(session_, saver_);
  ImGui::End();
}

void Viewer::useKeys() {
  const std::vector<KeyPress> presses = window_.takeKeys();
  if (ImGui::GetIO().WantTextInput) return;
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) keys_ = false;
  for (const KeyPress& press : presses) {
    if (press.typed == U'?') keys_ = !keys_;
    if (press.key == GLFW_KEY_ESCAPE) keys_ = false;
    if (press.control && press.key == GLFW_KEY_Q) {
      glfwSetWindowShouldClose(window_.handle(), GLFW_TRUE);
    }
    if (!press.control && !press.repeated) {
      if (press.key == GLFW_KEY_TAB) panels_ = !panels_;
      if (press.key == GLFW_KEY_P) session_.wanted = Save::Picture;
      if (press.key == GLFW_KEY_S) session_.wanted = Save::Scene;
    }
    PictureInput::useKey(press, session_, area_);
  }
}

void Viewer::drawInterface() {
  interface_.begin();
  controls::beginFrame();
  layOut();
  if (stage_.hasScene()) {
    useKeys();
    input_.useMouse(session_, area_, poke_);
    if (panels_) drawPanels();
    const Projection projection(session_.scene.camera, area_);
    if (session_.aov < Aov::DsmPosition) {
      if (session_.scaleBar) drawScaleBar(session_, projection, area_);
      if (session_.gizmos) {
        input_.handles().draw(session_, projection, *ImGui::GetBackgroundDrawList());
      }
    }
    if (session_.divided) drawDivider(session_, area_);
    if (keys_) drawKeys(area_);
  }
  if (!message_.empty()) {
    drawCaption(message_.c_str(), area_);
  } else if (stage_.isPreview()) {
    drawCaption("better-dipole while it moves", area_);
  }
  interface_.end();
  if (options_.controls) writeControls();
}

void Viewer::drawPicture() {
  if (!stage_.hasScene() || area_.empty()) return;
  const bool sliding = ImGui::IsAnyItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left);
  const bool moving =
      session_.playback.playing || session_.playback.turntable || input_.dragging() || sliding;
  const bool resized = area_.width != drawn_.width || area_.height != drawn_.height;
  // What was drawn for speed is drawn well once nothing moves.
  if (!session_.edits.any() && !resized && !(rough_ && !moving)) return;
  rough_ = moving;
  drawn_ = area_;
  stage_.draw(session_, area_.width, area_.height, moving);
  awake_ = std::max(awake_, 1);
  if (!moving) stage_.finish();
}

void Viewer::takeFinished() {
  if (framesTaken_ == stage_.framesFinished()) return;
  framesTaken_ = stage_.framesFinished();
  history_.add(stage_.lastFrame());
  session_.report = stage_.report();
  if (stage_.lastFrame().provisional) session_.edits.picture = true;
  awake_ = std::max(awake_, 1);
  if (session_.aov == Aov::Radiance || stage_.lastFrame().images.empty()) return;
  const Image& image = stage_.lastFrame().images.front();
  variable_.set(isLight(session_.aov) ? image
                                      : asColors(image, session_.aov, session_.surfelIndex));
  variableShown_ = session_.aov;
}

// Picture, variable, truth or heat map.
void Viewer::drawShown(VkCommandBuffer commands) {
  const core::ToneOptions plain{0, core::ToneCurve::None, session_.tone.background};
  const auto draw = [&](const DeviceImage& image, const core::ToneOptions& tone) {
    const Area place =
        fitted(area_, static_cast<int>(image.extent.width), static_cast<int>(image.extent.height));
    painter_.draw(commands, image, place, place, tone);
  };
  if (session_.shown != Shown::Picture && truth_.hasPicture()) {
    if (session_.shown == Shown::Truth) return draw(truth_.truth(), session_.tone);
    return draw(truth_.heatMap(), plain);
  }
  const bool variable = session_.aov != Aov::Radiance && variableShown_ == session_.aov;
  if (variable && !variable_.empty()) {
    return draw(variable_.shown(), isLight(session_.aov) ? session_.tone : plain);
  }
  painter_.draw(commands, stage_.picture(), area_, area_, session_.tone);
}

void Viewer::present() {
  const std::optional<VkCommandBuffer> commands = presenter_.begin();
  if (!commands) return;
  if (stage_.hasScene() && !area_.empty()) {
    drawShown(*commands);
    if (stage_.paper() && session_.shown == Shown::Picture) {
      Area left = area_;
      left.width = static_cast<int>(session_.divider * static_cast<float>(area_.width));
      painter_.draw(*commands, *stage_.paper(), area_, left, session_.tone);
    }
  }
  interface_.draw(*commands);
  presenter_.end();
}

void Viewer::save() {
  const Save wanted = std::exchange(session_.wanted, Save::Nothing);
  if (wanted == Save::Nothing && !saver_.filming()) return;
  const auto named = [&](const char* ending) {
    return std::filesystem::path(session_.saveName + ending);
  };
  failed_ = false;
  try {
    stage_.finish();
    if (wanted == Save::Picture) {
      message_ = saver_.savePicture(session_, named(".png"), area_.width, area_.height);
    } else if (wanted == Save::Exr) {
      message_ = saver_.savePicture(session_, named(".exr"), area_.width, area_.height);
    } else if (wanted == Save::Scene) {
      message_ = Saver::saveScene(session_, named(".toml"), area_.width, area_.height);
    } else if (wanted == Save::Film) {
      poke_.end();
      session_.playback.playing = false;
      saver_.startFilm(session_, named(".mp4"), area_.width, area_.height);
    } else if (wanted == Save::NoFilm) {
      saver_.cancelFilm();
      message_ = "the film was stopped";
    }
    if (saver_.filming()) {
      const std::optional<std::string> done = saver_.step();
      message_ = done.value_or(fmt::format("filming, {:.0f} %", 100 * saver_.progress()));
      if (done) session_.edits.picture = true;
    }
  } catch (const std::exception& error) {
    message_ = error.what();
    failed_ = true;
  }
  awake_ = std::max(awake_, framesAfterEvent);
}

void Viewer::followTruth() {
  if (std::exchange(session_.cancelTruth, false)) truth_.cancel();
  if (session_.wantedTruth && stage_.hasScene() && !area_.empty()) {
    stage_.finish();
    poke_.end();
    try {
      truth_.start(session_, renderer_, *session_.wantedTruth, area_.width, area_.height);
    } catch (const Error& error) {
      message_ = error.what();
      failed_ = true;
    }
    session_.edits.picture = true;
  }
  session_.wantedTruth.reset();
  if (truth_.update()) awake_ = std::max(awake_, framesAfterEvent);
}

void Viewer::writeControls() const {
  Json places = Json::object();
  for (const controls::Place& place : controls::places()) {
    places[place.name] = {place.x, place.y, place.width, place.height};
  }
  const Json json{{"picture", {area_.x, area_.y, area_.width, area_.height}},
                  {"controls", std::move(places)},
                  {"message", message_},
                  {"frames", stage_.framesFinished()},
                  {"idle", awake_ == 0 && !session_.edits.any() && !loader_.busy() &&
                               !saver_.filming() && !poke_.moves()},
                  {"truth", truth_.running()      ? truth_.progress()
                            : truth_.hasPicture() ? 1
                                                  : 0}};
  core::writeWhole(*options_.controls, toText(json));
}

Json Viewer::report() const {
  if (!session_.report) return nullptr;
  return renderReportJson(*session_.report, session_.options, {});
}

void Viewer::run() {
  while (!window_.wantsToClose()) {
    sleepUntilNeeded();
    openDropped();
    takeLoaded();
    const Clock::time_point now = Clock::now();
    // What took long did not play: time goes on from what was seen.
    advance(std::min(std::chrono::duration<double>(now - last_).count(), 0.1));
    last_ = now;
    drawInterface();
    save();
    followTruth();
    drawPicture();
    takeFinished();
    present();
  }
  stage_.finish();
  presenter_.waitIdle();
  keepState();
}

}  // namespace opaline::app::viewer
