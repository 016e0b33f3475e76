#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "film/frames_asked_for.h"
#include "viewer/panels/controls.h"
#include "viewer/panels/panels.h"

namespace opaline::app::viewer {

namespace {

using Size = std::optional<std::array<int, 2>>;

constexpr int mostPixels = 16384;
constexpr int mostFrames = 1'000'000;

void drawPictureSize(Session& session) {
  static const Choices<Size> usual{
      {"as in the window", std::nullopt},  {"1280 x 720", Size({1280, 720})},
      {"1920 x 1080", Size({1920, 1080})}, {"3840 x 2160", Size({3840, 2160})},
      {"1024 x 1024", Size({1024, 1024})}, {"2048 x 2048", Size({2048, 2048})}};
  Size& size = session.pictureSize;
  const bool known = std::any_of(usual.begin(), usual.end(),
                                 [&](const auto& entry) { return entry.second == size; });
  Choices<Size> choices = usual;
  if (!known) choices.emplace_back(fmt::format("{} x {}", (*size)[0], (*size)[1]), size);
  bool changed =
      controls::choice("size", size, choices,
                       "Size of the saved picture in pixels. The window shows just that part.");
  if (size) {
    changed |= controls::typed("width", (*size)[0], 16, mostPixels, "Of what is saved, pixels.");
    changed |= controls::typed("height", (*size)[1], 16, mostPixels, "Of what is saved, pixels.");
  }
  if (changed) session.edits.picture = true;
}

void drawBackground(Session& session) {
  if (controls::checkbox("environment behind", session.options.environmentBehind,
                         "Shows the environment where no surface is."))
    session.edits.picture = true;
  if (!session.tone.background || session.options.environmentBehind) return;
  Rgb& background = *session.tone.background;
  if (!controls::light("background", background, "Colour behind the scene, linear, from 0 to 1."))
    return;
  for (float& channel : background) channel = std::min(channel, 1.0F);
  session.edits.picture = true;
}

bool chooseRate(double& perSecond) {
  static const Choices<double> usual{{"24", 24}, {"25", 25}, {"30", 30}, {"50", 50}, {"60", 60}};
  const bool known = std::any_of(usual.begin(), usual.end(),
                                 [&](const auto& entry) { return entry.second == perSecond; });
  Choices<double> choices = usual;
  if (!known) choices.emplace_back(fmt::format("{}", perSecond), perSecond);
  return controls::choice("frames a second", perSecond, choices, "Of a film.");
}

void drawFilm(Session& session) {
  FilmSettings& film = session.film;
  bool changed = chooseRate(film.perSecond);
  if (controls::checkbox("the motion once", film.once,
                         "Saves all of the motion; otherwise the frames that you set, which also "
                         "play then.")) {
    changed = true;
    if (!film.once) {
      film.once = true;
      const FrameRange all = filmFrames(session);
      film = {film.perSecond, false, all.first, all.last};
    }
  }
  if (!film.once) {
    changed |= controls::typed("first frame", film.first, 0, mostFrames,
                               "Frame n shows the time n over the rate.");
    film.last = std::max(film.last, film.first);
    changed |= controls::typed("last frame", film.last, film.first, mostFrames,
                               "It is part of the film, and not before the first.");
  }
  if (changed) fitPlayback(session);
  const FrameRange frames = filmFrames(session);
  ImGui::TextDisabled("film: %s, %.2f s", countOfFrames(frames.count()).c_str(),
                      static_cast<double>(frames.count()) / frames.perSecond);
}

}  // namespace

void drawSavePanel(Session& session, const Saver& saver) {
  if (!controls::section("Save", false)) return;
  const auto choose = [&](const char* name, FileUse use, const char* about) {
    if (controls::button(name, about)) session.wantedFile = use;
  };
  choose("picture...", FileUse::SavePicture,
         "As PNG: the picture, or the variable chosen in View, by your method. Key P saves it "
         "without asking.");
  ImGui::SameLine();
  choose("EXR...", FileUse::SaveExr, "The same as linear values, in 32-bit floats.");
  ImGui::SameLine();
  choose("scene...", FileUse::SaveScene,
         "As TOML: opaline render draws the same from it. Keys: Ctrl S; S saves without asking.");
  if (saver.filming()) {
    ImGui::ProgressBar(static_cast<float>(saver.progress()));
    if (controls::button("stop the film", "The unfinished film is deleted."))
      session.wanted = Save::NoFilm;
  } else {
    ImGui::SameLine();
    choose("film...", FileUse::SaveFilm, "As MP4: the frames below, their light.");
  }
  controls::hint(fmt::format("P and S save {}, or its next free name.", session.saveName));
  drawPictureSize(session);
  drawBackground(session);
  drawFilm(session);
}

}  // namespace opaline::app::viewer
