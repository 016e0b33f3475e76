#include "viewer/viewer.h"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "film/framing.h"
#include "opaline/error.h"
#include "viewer/files/folder_listing.h"
#include "viewer/session/work_under_way.h"

// Opening, saving and computing on the user's behalf, and the questions before it.
namespace opaline::app::viewer {

namespace {

// What can be dropped on the window is more than a scene.
std::string withKindsOfFiles(std::string error) {
  constexpr std::string_view ofScenes = "a scene is a ";
  if (error.find(ofScenes) != std::string::npos) error += "; an environment is .hdr or .exr";
  return error;
}

}  // namespace

void Viewer::openFile(const std::filesystem::path& file) {
  const auto begin = [this, file] {
    stopWork(saver_, truth_);
    notice_.reset();
    SceneOptions asked;
    asked.setFile(file);
    open(asked);
  };
  const std::optional<std::string> lost = workUnderWay(saver_, truth_);
  if (!lost) return begin();
  question_.ask({fmt::format("{} Open {} anyway?", *lost, shownName(file.filename())),
                 "stop and open", "go on"},
                begin);
}

void Viewer::light(const std::filesystem::path& file) {
  if (!stage_.hasScene()) {
    return say(fmt::format("{} is light for a scene, and there is none yet: open a model first",
                           shownName(file.filename())),
               true);
  }
  try {
    takeEnvironment(file, session_);
  } catch (const std::exception& error) {
    say(error.what(), true);
  }
}

void Viewer::openDropped() {
  for (const std::filesystem::path& file : window_.takeDropped()) {
    if (isEnvironment(file)) {
      light(file);
    } else {
      files_.close();
      openFile(file);
    }
  }
}

void Viewer::takeFile(FileAnswer answer) {
  if (answer.use == FileUse::OpenScene) return openFile(answer.file);
  if (answer.use == FileUse::OpenEnvironment) return light(answer.file);
  std::error_code error;
  if (!answer.mayReplace && std::filesystem::exists(answer.file, error)) {
    std::string text = fmt::format("{} already exists. Replace it?", shownName(answer.file));
    answer.mayReplace = true;
    question_.ask({std::move(text), "replace", "keep"}, [this, answer] { takeFile(answer); });
    return;
  }
  session_.wanted = answer.use == FileUse::SavePicture ? Save::Picture
                    : answer.use == FileUse::SaveExr   ? Save::Exr
                    : answer.use == FileUse::SaveScene ? Save::Scene
                                                       : Save::Film;
  // For a file in the current folder the name alone is enough.
  if (answer.file.parent_path() == std::filesystem::current_path(error)) {
    answer.file = answer.file.filename();
  }
  session_.saveTo = std::move(answer);
}

void Viewer::takeLoaded() {
  // A film needs the scene it was begun with, so a new one waits for its end.
  if (dashboard_.area().empty() || stage_.isBusy() || saver_.keepsRenderer()) return;
  std::optional<Loader::Result> result = loader_.take();
  if (!result) return;
  if (!result->loaded) {
    reaching_ = false;
    return say(withKindsOfFiles(result->error), true);
  }
  try {
    Session made = resizing_ ? resized(session_, std::move(*result))
                             : opened(std::move(*result), options_.prepare);
    dashboard_.layOut(made);
    const Area& area = dashboard_.area();
    if (!resizing_) {
      // Files go on into the folder of the last.
      const std::filesystem::path last(session_.saveName);
      if (made.saveName.empty()) made.saveName = (last.parent_path() / made.name).string();
      showAll(made.scene, {made.time.clip, area.aspect(), made.sequence.get(),
                           someMoments(lengthOfMotion(made), made.sequence.get())});
    }
    made.gizmos = session_.gizmos;
    made.scaleBar = session_.scaleBar;
    poke_.end();
    stage_.setScene(made.scene, session_.scene);
    session_ = std::move(made);
    truth_.noteEdit();
    if (!resizing_) {
      truth_.forget();
      undo_.begin(editStateOf(session_));
      reaching_ = false;
    }
    history_.clear();
    framesTaken_ = stage_.framesFinished();
    window_.setTitle(fmt::format("{} - Opaline", session_.name));
  } catch (const Error& error) {
    reaching_ = false;
    sequence_.forget();
    session_.edits.picture = stage_.hasScene();
    say(error.what(), true);
  }
}

// Returns true on the second call, after the window was drawn with a sign that the task takes a
// moment.
bool Viewer::announce() {
  announced_ = !announced_;
  return !announced_;
}

void Viewer::save() {
  const bool ofPicture = session_.wanted == Save::Picture || session_.wanted == Save::Exr ||
                         session_.wanted == Save::Film;
  if (saver_.filming() && ofPicture) {
    say("a film is being made: no other picture can be saved before its end", true);
    session_.wanted = Save::Nothing;
    session_.saveTo.reset();
  }
  if (session_.wanted == Save::Nothing || stage_.isBusy()) return;
  // A film that was stopped keeps the renderer until its frame is done.
  if ((ofPicture && saver_.keepsRenderer()) || !announce()) return;
  const Save wanted = std::exchange(session_.wanted, Save::Nothing);
  if (wanted == Save::Film) {
    poke_.end();
    session_.playback.playing = session_.playback.turntable = false;
  }
  try {
    stage_.finish();
    const Area& area = dashboard_.area();
    const auto [width, height] = session_.pictureSize.value_or(std::array{area.width, area.height});
    if (const auto done = saver_.save(wanted, session_, width, height)) say(*done);
    // Later files go beside it, under its name.
    if (const std::optional<FileAnswer>& to = session_.saveTo)
      session_.saveName = (to->file.parent_path() / to->file.stem()).string();
  } catch (const std::exception& error) {
    say(error.what(), true);
  }
  session_.saveTo.reset();
}

void Viewer::followFilm() {
  // A truth that was asked for begins between two frames.
  if (!saver_.keepsRenderer() || (session_.wantedTruth && !saver_.isBusy())) return;
  try {
    if (const auto done = saver_.step()) say(*done);
  } catch (const std::exception& error) {
    say(error.what(), true);
  }
  if (!saver_.keepsRenderer()) session_.edits.picture = true;
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
    say(truth_.save(*what, {session_.saveName + ending, Existing::TakeNextName}, session_.tone));
  } catch (const std::exception& error) {
    say(error.what(), true);
  }
}

void Viewer::followTruth() {
  if (std::exchange(session_.cancelTruth, false)) truth_.cancel();
  if (session_.wantedTruth && !stage_.isBusy() && !saver_.isBusy() && announce()) startTruth();
  saveTruth();
  if (truth_.update()) stayAwake();
}

}  // namespace opaline::app::viewer
