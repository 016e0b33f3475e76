#include "viewer/session/edit_state.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <variant>

#include "cli/motion_options.h"
#include "cli/picture_options.h"
#include "scene/environment_file.h"
#include "viewer/session/light_list.h"

namespace opaline::app::viewer {

namespace {

// As many names as there are members, so that a new one does not compile before it is here.

bool same(const Medium& a, const Medium& b) {
  const auto parts = [](const Medium& medium) {
    const auto& [name, sigmaS, sigmaA, eta] = medium;
    return std::tie(name, sigmaS, sigmaA, eta);
  };
  return parts(a) == parts(b);
}

bool same(const DirectionalLight& a, const DirectionalLight& b) {
  const auto parts = [](const DirectionalLight& light) {
    const auto& [direction, irradiance] = light;
    return std::tie(direction, irradiance);
  };
  return parts(a) == parts(b);
}

bool same(const PointLight& a, const PointLight& b) {
  const auto parts = [](const PointLight& light) {
    const auto& [position, intensity] = light;
    return std::tie(position, intensity);
  };
  return parts(a) == parts(b);
}

bool same(const SpotLight& a, const SpotLight& b) {
  const auto parts = [](const SpotLight& light) {
    const auto& [position, direction, intensity, inner, outer] = light;
    return std::tie(position, direction, intensity, inner, outer);
  };
  return parts(a) == parts(b);
}

auto partsOf(const RectangleLight& light) {
  const auto& [centre, u, v, radiance, twoSided] = light;
  return std::tie(centre, u, v, radiance, twoSided);
}

auto partsOf(const DiscLight& light) {
  const auto& [centre, normal, radius, radiance, twoSided] = light;
  return std::tie(centre, normal, radius, radiance, twoSided);
}

auto partsOf(const SphereLight& light) {
  const auto& [centre, radius, radiance] = light;
  return std::tie(centre, radius, radiance);
}

auto partsOf(const TubeLight& light) {
  const auto& [from, to, radius, radiance] = light;
  return std::tie(from, to, radius, radiance);
}

bool same(const AreaLight& a, const AreaLight& b) {
  if (a.index() != b.index()) return false;
  return std::visit(
      [&](const auto& light) {
        return partsOf(light) == partsOf(std::get<std::remove_cvref_t<decltype(light)>>(b));
      },
      a);
}

bool same(const Deformer& a, const Deformer& b) {
  const auto parts = [](const Deformer& deformer) {
    const auto& [kind, amount, period] = deformer;
    return std::tie(kind, amount, period);
  };
  return parts(a) == parts(b);
}

template <typename T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const T& x, const T& y) { return same(x, y); });
}

bool sameLights(const Lighting& a, const Lighting& b) {
  return same(a.directional, b.directional) && same(a.points, b.points) && same(a.spots, b.spots) &&
         same(a.areas, b.areas) && a.ambient == b.ambient;
}

bool sameEnvironment(const EditState& state, const Session& session) {
  const auto& file = session.source.environment;
  if (state.environment != session.environment) return false;
  if (!state.environmentFile || !file) return state.environmentFile.has_value() == file.has_value();
  return state.environmentFile->rotationDegrees == file->rotationDegrees &&
         state.environmentFile->intensity == file->intensity;
}

// Options and tone as a scene file has them: all that makes a picture.
bool sameLook(const EditState& state, const Session& session) {
  core::ToneOptions tone = session.tone;
  // What follows from the light is no edit of its own.
  if (session.exposesByLight) tone.exposureStops = state.tone.exposureStops;
  using Picture = options::PictureSettings;
  return options::chosenIn(Picture{.render = state.options, .tone = state.tone}) ==
         options::chosenIn(Picture{.render = session.options, .tone = tone});
}

template <typename OfState>
auto viewOfState(OfState& s) {
  return std::tie(s.fovDegrees, s.exposesByLight, s.speed, s.lengthSeconds, s.loop,
                  s.quickWhileMoving, s.divided, s.aov, s.surfelIndex, s.treeLevel, s.film,
                  s.pictureSize, s.clip);
}

template <typename OfSession>
auto viewOf(OfSession& s) {
  return std::tie(s.scene.camera.verticalFovDegrees, s.exposesByLight, s.playback.speed,
                  s.playback.lengthSeconds, s.playback.loop, s.quickWhileMoving, s.divided, s.aov,
                  s.surfelIndex, s.treeLevel, s.film, s.pictureSize, s.time.clip);
}

bool sameMedium(const EditState& state, const Session& session, std::size_t object) {
  return same(state.media[object], session.scene.objects[object].medium);
}

bool sameMedia(const EditState& state, const Session& session) {
  if (state.media.size() != session.scene.objects.size()) return false;
  for (std::size_t i = 0; i < state.media.size(); ++i) {
    if (!sameMedium(state, session, i)) return false;
  }
  return true;
}

void restoreEnvironment(const EditState& state, Session& session) {
  session.environment = state.environment;
  session.source.environment = state.environmentFile;
  const double degrees = state.environmentFile ? state.environmentFile->rotationDegrees : 0;
  session.scene.lighting.environment =
      state.environment && degrees != 0
          ? std::make_shared<const Image>(scene::turned(*state.environment, degrees))
          : state.environment;
}

}  // namespace

EditState editStateOf(const Session& session) {
  EditState state;
  for (const Object& object : session.scene.objects) state.media.push_back(object.medium);
  state.lighting = session.scene.lighting;
  // A turned one is made again where it is wanted: hundreds of them would fill the memory.
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
  return hasSizeOf(state, session) && sameMedia(state, session) &&
         sameLights(state.lighting, session.scene.lighting) && sameEnvironment(state, session) &&
         same(state.deformers, session.scene.deformers) && sameLook(state, session) &&
         viewOfState(state) == viewOf(session);
}

bool hasSizeOf(const EditState& state, const Session& session) {
  return state.diagonalMm == session.asked.diagonalMm();
}

void restore(const EditState& state, Session& session) {
  Edits& edits = session.edits;
  const std::size_t objects = std::min(state.media.size(), session.scene.objects.size());
  for (std::size_t i = 0; i < objects; ++i) {
    if (sameMedium(state, session, i)) continue;
    session.scene.objects[i].medium = state.media[i];
    edits.medium[i] = true;
  }
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
  if (!same(state.deformers, session.scene.deformers)) {
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
