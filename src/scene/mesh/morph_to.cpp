#include "scene/mesh/morph_to.h"

#include <fmt/format.h>

#include "opaline/error.h"
#include "scene/formats.h"
#include "scene/mesh/same_topology.h"
#include "scene/rig.h"
#include "scene/text.h"
#include "scene/vector_math.h"

namespace opaline::scene {

namespace {

/// The first half goes to the target, gently at both ends; the second returns.
constexpr float clipSeconds = 4;

Clip thereAndBack() {
  Track track;
  track.target = TrackTarget::MorphWeights;
  track.interpolation = Interpolation::CubicSpline;
  track.seconds = {0, clipSeconds / 2, clipSeconds};
  track.values = {0, 0, 0, 0, 1, 0, 0, 0, 0};  // tangents of 0 around each value
  return {"morph", clipSeconds, {track}};
}

}  // namespace

void addMorph(RawScene& scene, const std::filesystem::path& file,
              const std::filesystem::path& other, const LogCallback& log) {
  const std::string use = "a morph to another mesh";
  const std::string name = cleanText(file.string(), 1000);
  const std::string otherName = cleanText(other.string(), 1000);
  RawObject& object = onlyStillObject(scene, name, use);
  RawScene target = loadModel(other, log);
  const RawMesh& from = object.mesh;
  const RawMesh& to = onlyStillObject(target, otherName, use).mesh;
  const std::string difference = differenceOf(faceListOf(from), faceListOf(to));
  if (!difference.empty()) {
    throw Error(
        fmt::format("{} and {} differ in more than positions, so that one cannot become "
                    "the other: {}",
                    name, otherName, difference));
  }
  Rig rig;
  rig.positions = from.positions;
  rig.normals = from.normals;
  rig.normals.resize(from.positions.size(), Vec3{0, 0, 0});
  MorphTarget& morph = rig.targets.emplace_back();
  for (std::size_t v = 0; v < from.positions.size(); ++v) {
    morph.positions.push_back(toFloat(toDouble(to.positions[v]) - toDouble(from.positions[v])));
  }
  startProvenance(object.mesh);
  object.rig = std::move(rig);
  scene.nodes = {{"morph"}};
  scene.nodes[0].morphWeights = {0};
  scene.clips = {thereAndBack()};
}

}  // namespace opaline::scene
