#include "viewer/saver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "picture_options.h"
#include "scene/scene_writer.h"
#include "sequence_frames.h"

namespace opaline::app::viewer {

namespace {

std::string saved(const std::filesystem::path& file) {
  return fmt::format("saved {}", file.string());
}

// Which `opaline render` draws as the picture.
std::string saveScene(const Session& session, const std::filesystem::path& file, int width,
                      int height) {
  scene::SceneFileSettings settings =
      settingsOf(sized(session.options, width, height), session.tone, session.scene);
  if (session.exposesByLight) settings.exposureStops.reset();
  // Between the last file and the end, the last is shown; render knows no such time.
  if (session.sequence && settings.seconds) {
    settings.seconds = std::min(*settings.seconds, lastSecond(*session.sequence));
  }
  scene::writeScene(file, scene::describe(session.scene, session.source, settings));
  return saved(file);
}

}  // namespace

std::optional<std::string> Saver::save(Save wanted, const Session& session, int width, int height) {
  const auto named = [&](const char* ending) {
    return session.saveTo ? session.saveTo->file : std::filesystem::path(session.saveName + ending);
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

std::string Saver::savePicture(const Session& session, const std::filesystem::path& file, int width,
                               int height) {
  const RenderResult result = renderer_.render(sized(session.options, width, height));
  writePicture(file, result.images.front(), session.tone);
  return saved(file);
}

void Saver::startFilm(const Session& session, const std::filesystem::path& file, int width,
                      int height) {
  // Films have an even number of pixels each way.
  FilmOrder order;
  order.options = sized(session.options, std::max(2, width / 2 * 2), std::max(2, height / 2 * 2));
  order.frames = filmFrames(session);
  order.output = file;
  order.tone = session.tone;
  order.quiet = true;
  if (session.sequence) order.place = placeBySequence(session.sequence, order.frames.last);
  requireFilmWritable(order.output, order.frames);
  film_.emplace(std::move(order));
  filmFile_ = file;
}

std::optional<std::string> Saver::step() {
  try {
    film_->step(renderer_);
  } catch (...) {
    film_.reset();
    throw;
  }
  if (!film_->isDone()) return std::nullopt;
  film_.reset();
  return saved(filmFile_);
}

}  // namespace opaline::app::viewer
