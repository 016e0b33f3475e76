#include "film/framing.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <thread>
#include <utility>

#include "film/sequence_frames.h"
#include "opaline/error.h"
#include "opaline/framing.h"

namespace opaline::app {

namespace {

/// The part of the picture's half width and height that stays free around the scene, once the
/// camera has moved back.
constexpr double freeMargin = 0.03;

/// A longer film is sampled at this many moments; motion between them stays within the margin.
constexpr std::int64_t mostMoments = 1024;

/// A camera whose target is off centre by more than this part of a picture sees too little around
/// it.
constexpr float mostShift = 0.4F;

/// Calls use(position) for all vertices of the scene at that time.
template <typename Use>
void forEachPosition(const Scene& scene, const SceneTime& time,
                     const PositionsByObject& positionsMm, const Use& use) {
  const std::vector<std::vector<Vec3>> places = positionsAt(scene, time, positionsMm);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (scene.objects[i].isGround) continue;
    for (const Vec3& place : places[i]) use(place);
  }
}

/// What the moments require, for each margin.
struct Needs {
  Framing tight;
  Framing loose;
};

void add(const Scene& scene, const Framed& framed, const Moment& moment, Needs& to) {
  PositionsByObject positionsMm;
  try {
    if (moment.number) framed.sequence->read(*moment.number, positionsMm[0]);
  } catch (const Error&) {
    return;
  }
  const SceneTime time{moment.seconds, framed.clip};
  forEachPosition(scene, time, positionsMm, [&](const Vec3& p) {
    to.tight.add(p);
    to.loose.add(p);
  });
  if (moment.number && framed.kept != nullptr)
    framed.kept->keep(*moment.number, std::move(positionsMm[0]));
}

Needs needsOf(const Scene& scene, const Framed& framed) {
  const Needs none{{scene.camera, framed.aspect, 0}, {scene.camera, framed.aspect, freeMargin}};
  const std::size_t workers = std::clamp<std::size_t>(
      std::min<std::size_t>(framed.moments.size(), std::thread::hardware_concurrency()), 1, 8);
  std::vector<Needs> parts(workers, none);
  std::atomic<std::size_t> next = 0;
  const auto work = [&](Needs& part) {
    for (std::size_t i = next++; i < framed.moments.size(); i = next++) {
      add(scene, framed, framed.moments[i], part);
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < workers; ++i) others.emplace_back([&, i] { work(parts[i]); });
    work(parts[0]);
  }
  Needs all = none;
  for (const Needs& part : parts) {
    all.tight.add(part.tight);
    all.loose.add(part.loose);
  }
  return all;
}

}  // namespace

double aspectOf(const RenderOptions& options) {
  return static_cast<double>(options.width) / options.height;
}

std::vector<Moment> momentsOf(const FrameRange& frames, const MeshSequence* sequence) {
  std::vector<Moment> moments;
  const auto count = static_cast<std::int64_t>(frames.count());
  const std::int64_t looks = std::min(count, mostMoments);
  for (std::int64_t i = 0; i < looks; ++i) {
    // The first and last frame, and those between as evenly spaced as possible.
    const std::int64_t place = looks > 1 ? i * (count - 1) / (looks - 1) : 0;
    const int frame = static_cast<int>(frames.first + place * frames.step);
    moments.push_back({frames.seconds(frame), {}});
    if (sequence != nullptr) moments.back().number = numberOfFrame(*sequence, frame);
  }
  return moments;
}

std::vector<Moment> momentOf(double seconds, const MeshSequence* sequence) {
  if (sequence == nullptr) return {{seconds, {}}};
  return {{seconds, numberAt(*sequence, seconds)}};
}

std::vector<Moment> someMoments(double lengthSeconds, const MeshSequence* sequence) {
  const int count = sequence != nullptr ? 8 : 32;
  std::vector<Moment> moments;
  for (int i = 0; i < count; ++i) {
    moments.push_back({lengthSeconds * i / count, {}});
    if (sequence != nullptr) {
      moments.back().number = nearestNumber(*sequence, moments.back().seconds);
    }
  }
  return moments;
}

void showAll(Scene& scene, const Framed& framed) {
  if (scene.cameraChosen) return;
  Framed needed = framed;
  const bool stands = framed.sequence == nullptr && !moves(scene, framed.clip);
  if (stands && needed.moments.size() > 1) needed.moments.resize(1);
  const Needs needs = needsOf(scene, needed);
  if (!needs.tight.isMet()) scene.camera = needs.loose.camera();
}

void frame(Scene& scene, const SceneTime& time, const PositionsByObject& positionsMm,
           double aspect) {
  Vec3 low{INFINITY, INFINITY, INFINITY};
  Vec3 high{-INFINITY, -INFINITY, -INFINITY};
  std::vector<Vec3> all;
  forEachPosition(scene, time, positionsMm, [&](const Vec3& p) {
    if (!std::all_of(p.begin(), p.end(), [](float x) { return std::isfinite(x); })) return;
    all.push_back(p);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  });
  if (all.empty()) return;
  Camera& camera = scene.camera;
  const Vec3 target = middleOf({low, high});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    camera.positionMm[axis] += target[axis] - camera.targetMm[axis];
  }
  camera.targetMm = target;
  camera.shiftX = std::clamp(camera.shiftX, -mostShift, mostShift);
  camera.shiftY = std::clamp(camera.shiftY, -mostShift, mostShift);
  Framing framing(camera, aspect, freeMargin);
  for (const Vec3& p : all) framing.add(p);
  camera = framing.camera();
}

}  // namespace opaline::app
