#include "viewer/saver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "opaline/error.h"
#include "paths.h"
#include "picture_options.h"
#include "scene/scene_writer.h"

namespace opaline::app::viewer {

std::string Saver::savePicture(const Session& session, const std::filesystem::path& file, int width,
                               int height) {
  const std::string extension = extensionOf(file);
  if (extension != ".png" && extension != ".exr") {
    throw Error(fmt::format("{}: a picture is a .png or .exr", file.string()));
  }
  const RenderResult result = renderer_.render(sized(session.options, width, height));
  writePicture(file, result.images.front(), session.tone);
  return fmt::format("saved {}", file.string());
}

std::string Saver::saveScene(const Session& session, const std::filesystem::path& file, int width,
                             int height) {
  const scene::SceneFileSettings settings =
      settingsOf(sized(session.options, width, height), session.tone, session.scene);
  scene::writeScene(file, scene::describe(session.scene, session.source, settings));
  return fmt::format("saved {}", file.string());
}

void Saver::startFilm(const Session& session, const std::filesystem::path& file, int width,
                      int height) {
  // Films have an even number of pixels each way.
  FilmOrder order;
  order.options = sized(session.options, std::max(2, width / 2 * 2), std::max(2, height / 2 * 2));
  order.frames.last =
      std::max(0, static_cast<int>(std::lround(double{session.playback.lengthSeconds} *
                                               order.frames.perSecond)) -
                      1);
  order.output = file;
  order.tone = session.tone;
  order.quiet = true;
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
  return fmt::format("saved {}", filmFile_.string());
}

}  // namespace opaline::app::viewer
