#include "viewer/files/saver.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "cli/paths.h"
#include "cli/picture_options.h"
#include "film/film.h"
#include "film/sequence_frames.h"
#include "opaline/moment.h"
#include "opaline/scene_file.h"
#include "viewer/picture/variable_display.h"

namespace opaline::app::viewer {

namespace {

std::string saved(const std::filesystem::path& file, const Target& wanted) {
  return fmt::format("saved {}", nameText(file, wanted.path));
}

// Whether clips move the model's lights, and these are as the model has them. In a scene file they
// would stand still.
bool leavesLightsToModel(const Session& session) {
  const auto movesLights = [](const ClipChanges& changes) {
    return !changes.directional.empty() || !changes.points.empty() || !changes.spots.empty();
  };
  const std::vector<ClipChanges>& clips = session.scene.changes;
  return std::any_of(clips.begin(), clips.end(), movesLights) &&
         !session.scene.lighting.environment && session.scene.lighting == session.lightsAsLoaded;
}

// Writes a scene file that `opaline render` draws as the same picture.
std::string saveScene(const Session& session, const Target& target, int width, int height) {
  SceneFileSettings settings = settingsOf(
      {sized(session.options, width, height), session.time, session.tone}, session.scene);
  if (session.exposesByLight) settings.picture.erase("exposure");
  // Between the last file and the end the last file is shown; render knows no such time.
  if (session.sequence) {
    settings.picture.set(options::fieldOf<options::PictureSettings>("seconds"),
                         std::min(session.time.seconds, lastSecond(*session.sequence)));
  }
  SceneDescription description = describe(session.scene, session.source, settings);
  description.lightsOfModel = leavesLightsToModel(session);
  description.cameraOfModel = movesCamera(session.scene, session.time.clip);
  return saved(writeScene(target, description), target);
}

// What a saved picture shows where the window shows more, or something else.
std::string shownBy(const Session& session) {
  if (session.shown != Shown::Picture) return ": the picture; Truth saves the truth";
  return session.divided ? ": all of it by your method" : "";
}

}  // namespace

std::optional<std::string> Saver::save(Save wanted, const Session& session, int width, int height) {
  const auto named = [&](const char* ending) {
    if (!session.saveTo) {
      return Target(session.saveName + ending, Existing::TakeNextName);
    }
    return Target(session.saveTo->file,
                  session.saveTo->mayReplace ? Existing::Replace : Existing::TakeNextName);
  };
  switch (wanted) {
    case Save::Picture:
      return savePicture(session, named(".png"), width, height);
    case Save::Exr:
      return savePicture(session, named(".exr"), width, height);
    case Save::Scene:
      return saveScene(session, named(".toml"), width, height);
    case Save::Film:
      startFilm(session, named(".mp4"), width, height);
      return std::nullopt;
    case Save::NoFilm:
      cancelFilm();
      return "the film was stopped";
    case Save::Nothing:
      break;
  }
  return std::nullopt;
}

std::string Saver::savePicture(const Session& session, const Target& target, int width,
                               int height) {
  const Aov variable = session.aov;
  const Image image =
      pictureOf(session, renderer_, sized(session.options, width, height), variable);
  const bool isData = extensionOf(target.path) == ".exr" || isLight(variable);
  const std::filesystem::path file =
      isData ? writePicture(target, image, session.tone)
             : writePicture(target, asColors(image, variable, session.surfelIndex),
                            plainTone(session.tone));
  return saved(file, target) + shownBy(session);
}

void Saver::startFilm(const Session& session, const Target& target, int width, int height) {
  const int evenWidth = std::max(2, width / 2 * 2);
  const int evenHeight = std::max(2, height / 2 * 2);
  filmRemark_.clear();
  if (evenWidth != width || evenHeight != height) {
    filmRemark_ =
        fmt::format(", {}x{} pixels: films have an even width and height", evenWidth, evenHeight);
  }
  FilmOrder order;
  order.options = sized(session.options, evenWidth, evenHeight);
  order.clip = session.time.clip;
  order.frames = filmFrames(session);
  order.output = target;
  order.tone = session.tone;
  order.quiet = true;
  if (session.sequence) order.place = placeBySequence(session.sequence, order.frames);
  requireFilmWritable(order.output, order.frames);
  film_.emplace(std::move(order));
  filmTarget_ = target;
  stopped_ = false;
}

bool Saver::isBusy() const {
  return step_.valid() && step_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
}

void Saver::cancelFilm() {
  stopped_ = true;
  if (!step_.valid()) film_.reset();
}

std::optional<std::string> Saver::step() {
  if (isBusy()) return std::nullopt;
  try {
    if (step_.valid()) step_.get();
    if (filming() && !film_->isDone()) stepOn();
  } catch (...) {
    const bool isWanted = filming();
    film_.reset();
    if (isWanted) throw;
    return std::nullopt;
  }
  if (step_.valid() || (filming() && !film_->isDone())) return std::nullopt;
  std::optional<std::string> done;
  if (filming()) done = saved(film_->file(), filmTarget_) + filmRemark_;
  film_.reset();
  return done;
}

void Saver::stepOn() {
  const auto step = [this] { film_->step(renderer_); };
  if (inBackground_)
    step_ = std::async(std::launch::async, step);
  else
    step();
}

}  // namespace opaline::app::viewer
