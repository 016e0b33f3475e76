#include "viewer/session/opening.h"

#include <algorithm>
#include <utility>

#include "cli/motion_options.h"
#include "cli/paths.h"
#include "opaline/environment.h"

namespace opaline::app::viewer {

namespace {

// Gives newly loaded objects what was edited in the window. What the file says of the others may
// have changed.
void keepEdits(const Session& edited, std::vector<Object>& objects) {
  const std::size_t known = std::min(edited.scene.objects.size(), objects.size());
  for (std::size_t i = 0; i < known; ++i) {
    const Object& before = edited.scene.objects[i];
    objects[i].medium = before.medium;
    if (!edited.source.numbersOfObject.contains(before.name)) continue;
    objects[i].opaque = before.opaque;
    objects[i].surface = before.surface;
  }
}

// Everything must be drawn for the first time.
Edits newScene(const Scene& scene) {
  Edits edits;
  edits.material.assign(scene.objects.size(), false);
  edits.picture = true;
  return edits;
}

}  // namespace

Session opened(Loader::Result result, const Prepare& prepare) {
  LoadedScene& loaded = *result.loaded;
  Session made;
  made.name = result.source.name();
  made.asked = std::move(result.source);
  made.notes = std::move(result.notes);
  prepare(loaded, made);
  if (!made.tone.background) made.tone.background = Rgb{0.03F, 0.03F, 0.035F};
  made.scene = std::move(loaded.scene);
  made.source = std::move(loaded.source);
  if (const auto& from = made.source.environment) {
    made.environment = from->rotationDegrees == 0 ? made.scene.lighting.environment
                                                  : readEnvironment({from->file, from->intensity});
  }
  measure(made.scene, made);
  made.sequence = std::move(loaded.sequence);
  fitPlayback(made);
  made.playback.playing = (made.sequence || moves(made.scene, made.time.clip)) &&
                          made.time.seconds == made.playback.beginSeconds;
  made.edits = newScene(made.scene);
  return made;
}

Session resized(const Session& edited, Loader::Result result) {
  Scene& loaded = result.loaded->scene;
  Session made = edited;
  made.asked = std::move(result.source);
  made.notes = std::move(result.notes);
  made.source = std::move(result.loaded->source);
  made.source.environment = edited.source.environment;
  made.source.numbersOfObject = edited.source.numbersOfObject;
  made.sequence = std::move(result.loaded->sequence);
  made.positionsMm.clear();
  measure(loaded, made);
  made.report.reset();

  Scene& scene = made.scene;
  keepEdits(edited, loaded.objects);
  scene.objects = std::move(loaded.objects);
  scene.nodes = std::move(loaded.nodes);
  scene.clips = std::move(loaded.clips);
  scene.repairs = std::move(loaded.repairs);
  removeGround(scene);
  // The file may have changed, and have fewer objects.
  if (made.object >= scene.objects.size()) made.object = 0;
  const float factor = made.diagonalMm / edited.diagonalMm;
  scaleLightsAndCamera(double{factor}, scene);
  if (std::optional<Ground> ground = describeGround(edited.scene)) {
    *ground->heightMm *= factor;
    scene.objects.push_back(groundUnder(scene, *ground));
  }
  made.edits = newScene(scene);
  return made;
}

bool isEnvironment(const std::filesystem::path& file) {
  const std::string extension = extensionOf(file);
  return extension == ".hdr" || extension == ".exr";
}

void takeEnvironment(const std::filesystem::path& file, Session& session) {
  const EnvironmentFile dropped{std::filesystem::absolute(file)};
  session.scene.lighting.environment = readEnvironment(dropped);
  session.environment = session.scene.lighting.environment;
  session.source.environment = dropped;
  session.edits.lighting = true;
}

}  // namespace opaline::app::viewer
