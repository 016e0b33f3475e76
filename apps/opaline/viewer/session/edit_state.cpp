#include "viewer/session/edit_state.h"

#include <cstddef>

#include "cli/motion_options.h"
#include "cli/picture_options.h"
#include "opaline/environment.h"
#include "viewer/session/light_list.h"

namespace opaline::app::viewer {

namespace {

bool sameLights(const Lighting& a, const Lighting& b) {
  return a.directional == b.directional && a.points == b.points && a.spots == b.spots &&
         a.areas == b.areas && a.ambient == b.ambient;
}

bool sameEnvironment(const EditState& state, const Session& session) {
  const auto& file = session.source.environment;
  if (state.environment != session.environment) return false;
  if (!state.environmentFile || !file) return state.environmentFile.has_value() == file.has_value();
  return state.environmentFile->rotationDegrees == file->rotationDegrees &&
         state.environmentFile->intensity == file->intensity;
}

// Compares options and tone as a scene file has them, which is everything that makes a picture.
bool sameLook(const EditState& state, const Session& session) {
  ToneOptions tone = session.tone;
  // An exposure that follows from the light is not an edit.
  if (session.exposesByLight) tone.exposureStops = state.tone.exposureStops;
  using Picture = options::PictureSettings;
  return options::chosenIn(Picture{.render = state.options, .tone = state.tone}) ==
         options::chosenIn(Picture{.render = session.options, .tone = tone});
}

template <typename OfState>
auto viewOfState(OfState& s) {
  return std::tie(s.fovDegrees, s.exposesByLight, s.speed, s.beginSeconds, s.endSeconds, s.loop,
                  s.quickWhileMoving, s.divided, s.aov, s.surfelIndex, s.treeLevel, s.film,
                  s.pictureSize, s.clip);
}

template <typename OfSession>
auto viewOf(OfSession& s) {
  return std::tie(s.scene.camera.verticalFovDegrees, s.exposesByLight, s.playback.speed,
                  s.playback.beginSeconds, s.playback.endSeconds, s.playback.loop,
                  s.quickWhileMoving, s.divided, s.aov, s.surfelIndex, s.treeLevel, s.film,
                  s.pictureSize, s.time.clip);
}

bool sameMaterial(const EditState& state, const Session& session, std::size_t object) {
  return state.materials[object] == materialOf(session.scene.objects[object]);
}

bool sameMaterials(const EditState& state, const Session& session) {
  const std::size_t ground = groundOf(session.scene) != nullptr ? 1 : 0;
  if (state.materials.size() + ground != session.scene.objects.size()) return false;
  for (std::size_t i = 0; i < state.materials.size(); ++i) {
    if (!sameMaterial(state, session, i)) return false;
  }
  return true;
}

void restoreEnvironment(const EditState& state, Session& session) {
  session.environment = state.environment;
  session.source.environment = state.environmentFile;
  const double degrees = state.environmentFile ? state.environmentFile->rotationDegrees : 0;
  session.scene.lighting.environment =
      state.environment && degrees != 0
          ? std::make_shared<const Image>(turned(*state.environment, degrees))
          : state.environment;
}

}  // namespace

EditState editStateOf(const Session& session) {
  EditState state;
  for (const Object& object : session.scene.objects)
    if (!object.isGround) state.materials.push_back(materialOf(object));
  state.numbers = session.source.numbersOfObject;
  state.ground = describeGround(session.scene);
  state.lighting = session.scene.lighting;
  // The turned environment is not kept but made again: hundreds of them would fill the memory.
  state.lighting.environment.reset();
  state.environmentFile = session.source.environment;
  state.environment = session.environment;
  state.deformers = session.scene.deformers;
  state.options = session.options;
  state.tone = session.tone;
  state.diagonalMm = session.asked.diagonalMm();
  viewOfState(state) = viewOf(session);
  return state;
}

bool isStateOf(const EditState& state, const Session& session) {
  return hasSizeOf(state, session) && sameMaterials(state, session) &&
         sameLights(state.lighting, session.scene.lighting) && sameEnvironment(state, session) &&
         state.ground == describeGround(session.scene) &&
         state.deformers == session.scene.deformers && sameLook(state, session) &&
         viewOfState(state) == viewOf(session);
}

bool hasSizeOf(const EditState& state, const Session& session) {
  return state.diagonalMm == session.asked.diagonalMm();
}

void restore(const EditState& state, Session& session) {
  Edits& edits = session.edits;
  const std::size_t objects = std::min(state.materials.size(), session.scene.objects.size());
  for (std::size_t i = 0; i < objects; ++i) {
    if (sameMaterial(state, session, i)) continue;
    giveMaterial(state.materials[i], session.scene.objects[i]);
    edits.material[i] = true;
  }
  session.source.numbersOfObject = state.numbers;
  if (state.ground != describeGround(session.scene)) setGround(state.ground, session);
  Lighting& lighting = session.scene.lighting;
  const bool lights = !sameLights(state.lighting, lighting);
  if (lights) {
    lighting.directional = state.lighting.directional;
    lighting.points = state.lighting.points;
    lighting.spots = state.lighting.spots;
    lighting.areas = state.lighting.areas;
    lighting.ambient = state.lighting.ambient;
    if (session.light >= static_cast<int>(countOf(lighting))) session.light = -1;
  }
  const bool surroundings = !sameEnvironment(state, session);
  if (surroundings) restoreEnvironment(state, session);
  if (lights || surroundings) edits.lighting = true;
  if (state.deformers != session.scene.deformers) {
    session.scene.deformers = state.deformers;
    edits.deformers = true;
  }
  if (state.fovDegrees != session.scene.camera.verticalFovDegrees) edits.camera = true;
  session.options = state.options;
  session.tone = state.tone;
  viewOf(session) = viewOfState(state);
  exposeByLight(session);
  edits.picture = true;
}

}  // namespace opaline::app::viewer
