#include "viewer/session/session.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "film/sequence_frames.h"
#include "opaline/exposure.h"
#include "opaline/options/picture.h"
#include "viewer/picture/vectors.h"

namespace opaline::app::viewer {

bool showsScene(const Session& session) {
  return session.shown == Shown::Picture && session.aov < Aov::DsmPosition;
}

void measure(const Scene& loaded, Session& session) {
  session.diagonalMm = diagonalMm(loaded);
  session.centreMm = middleOf(boundsOf(loaded));
  session.lightsAsLoaded = loaded.lighting;
  session.lightsAsLoaded.environment.reset();
}

Vec3 placeInFile(const Vec3& placeMm, const Session& session) {
  return fromGlm(toGlm(placeMm) - toGlm(session.centreMm));
}

Vec3 placeInScene(const Vec3& placeInFileMm, const Session& session) {
  return fromGlm(toGlm(placeInFileMm) + toGlm(session.centreMm));
}

void setGround(const std::optional<Ground>& ground, Session& session) {
  removeGround(session.scene);
  if (ground) session.scene.objects.push_back(groundUnder(session.scene, *ground));
  session.object = std::min(session.object, session.scene.objects.size() - 1);
  session.edits.material.resize(session.scene.objects.size());
  session.edits.ground = true;
}

void exposeByLight(Session& session) {
  if (session.exposesByLight) session.tone.exposureStops = automaticExposureStops(session.scene);
}

RenderOptions sized(const RenderOptions& options, int width, int height) {
  RenderOptions sized = options;
  sized.width = width;
  sized.height = height;
  return sized;
}

RenderOptions coarser(const RenderOptions& options) {
  RenderOptions coarse = options;
  // This saves most time for the least change of colour: fewer bounces or a looser tolerance would
  // change it more.
  coarse.tolerance = std::max(options.tolerance, 0.05F);
  return coarse;
}

RenderOptions coarselyDivided(const RenderOptions& options, std::size_t surfels) {
  constexpr int clusters = 1024;
  constexpr int shadowTexels = 512;
  // Surfels of twice the size still resolve a medium's light. With larger ones the sums over them
  // would take longer.
  constexpr std::size_t surfelsForOne = 4;
  RenderOptions coarse = coarser(options);
  coarse.maxClusters = std::min(options.maxClusters, clusters);
  coarse.shadowSize = std::min(options.shadowSize, shadowTexels);
  const double least = opaline::options::fieldOf<opaline::options::PictureSettings>("max_surfels")
                           .allowed.range.least;
  const bool asTheMediumAsks = surfels < static_cast<std::size_t>(options.maxSurfels);
  if (asTheMediumAsks)
    coarse.maxSurfels =
        std::max(static_cast<int>(surfels / surfelsForOne), static_cast<int>(least));
  return coarse;
}

Image pictureOf(const Session& session, Renderer& renderer, const RenderOptions& options,
                Aov variable) {
  renderer.setTime(session.time);
  RenderOptions levelled = options;
  levelled.treeLevel = session.treeLevel;
  return std::move(View(renderer, levelled).render({.aovs = {variable}}).images.front());
}

RenderOptions paperOptions(const RenderOptions& options) {
  RenderOptions paper = options;
  paper.transport = Transport::Dipole;
  paper.sum = Sum::Pattern;
  paper.site = Site::Fragment;
  return paper;
}

std::string complaintAboutPattern(const Scene& scene) {
  const bool hasGround = std::any_of(scene.objects.begin(), scene.objects.end(),
                                     [](const Object& object) { return object.isGround; });
  if (hasGround) return "the pattern of Gong et al. 2008 lights no ground: remove it under Light";
  const bool hasOpaque =
      std::any_of(scene.objects.begin(), scene.objects.end(),
                  [](const Object& object) { return object.opaque.has_value(); });
  if (hasOpaque) return "the pattern of Gong et al. 2008 lights no opaque bodies";
  return {};
}

float lengthOfMotion(const Session& session) {
  constexpr float usual = 4;
  const Scene& scene = session.scene;
  const int clip = session.time.clip;
  if (session.sequence) return static_cast<float>(secondsOf(*session.sequence));
  if (clip >= 0 && static_cast<std::size_t>(clip) < scene.clips.size()) {
    const float seconds = scene.clips[static_cast<std::size_t>(clip)].seconds;
    if (seconds > 0) return seconds;
  }
  float longest = 0;
  for (const Deformer& deformer : scene.deformers) {
    longest = std::max(longest, deformer.periodSeconds);
  }
  return longest > 0 ? longest : usual;
}

bool movesInTime(const Session& session) {
  return session.sequence || moves(session.scene, session.time.clip);
}

FrameRange filmFrames(const Session& session) {
  const FilmSettings& film = session.film;
  FrameRange frames;
  frames.perSecond = film.perSecond;
  if (!film.once) {
    frames.first = film.first;
    frames.last = std::max(film.first, film.last);
  } else if (session.sequence) {
    frames.last = session.sequence->frameCount() - 1;  // one frame per file at any frame rate
  } else {
    const double count = session.playback.endSeconds * film.perSecond;
    frames.last = std::max(0, static_cast<int>(std::lround(count)) - 1);
  }
  return frames;
}

void fitPlayback(Session& session) {
  Playback& playback = session.playback;
  playback.beginSeconds = 0;
  playback.endSeconds = lengthOfMotion(session);
  if (session.film.once) return;
  const FrameRange frames = filmFrames(session);
  const MeshSequence* const sequence = session.sequence.get();
  playback.beginSeconds = shownAt(sequence, frames, frames.first);
  playback.endSeconds = shownAt(sequence, frames, frames.last + 1);
  if (sequence == nullptr) return;
  playback.beginSeconds = std::min(playback.beginSeconds, lastSecond(*sequence));
  playback.endSeconds = std::min(playback.endSeconds, secondsOf(*sequence));
}

}  // namespace opaline::app::viewer
