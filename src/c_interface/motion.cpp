#include "opaline/motion.h"

#include <fmt/format.h>

#include <cstdint>
#include <vector>

#include "c_interface/status.h"
#include "c_interface/values.h"
#include "opaline/positions.h"
#include "opaline/sequence.h"

struct OpalineSequence : opaline::c::Handle<OpalineSequence> {
  opaline::MeshSequence sequence;
};

static_assert(static_cast<int>(opaline::DeformerKind::Wobble) == OpalineWobble);

using namespace opaline;
using opaline::c::guarded;
using opaline::c::required;

extern "C" {

OpalineStatus opalineClipCount(const OpalineScene* scene, size_t* count) {
  return guarded([&] { required(count, "count") = required(scene, "scene").scene.clips.size(); });
}

OpalineStatus opalineClipFacts(const OpalineScene* scene, size_t clip, OpalineClipFacts* facts) {
  return guarded([&] {
    const Clip& of = c::oneOf(required(scene, "scene").scene.clips, clip, "clip");
    c::give({0, of.name.c_str(), of.seconds}, facts, "facts");
  });
}

OpalineStatus opalineAddDeformer(OpalineScene* scene, OpalineDeformerKind kind, float amount,
                                 float periodSeconds) {
  return guarded([&] {
    std::vector<Deformer>& deformers = required(scene, "scene").scene.deformers;
    if (deformers.size() == maxDeformers)
      throw UsageError(fmt::format("There may be {} deformers.", maxDeformers));
    deformers.push_back(c::sound(Deformer{
        c::choiceOf<DeformerKind>(kind, OpalineWobble, "deformer"), amount, periodSeconds}));
  });
}

OpalineStatus opalineClearDeformers(OpalineScene* scene) {
  return guarded([&] { required(scene, "scene").scene.deformers.clear(); });
}

OpalineStatus opalinePositionsAt(const OpalineScene* scene, double seconds, int32_t clip,
                                 size_t object, float* positionsMm, size_t vertexCount) {
  return guarded([&] {
    c::objectOf(scene, object);
    c::give(positionsAt(scene->scene, {seconds, clip})[object], positionsMm, vertexCount,
            "positionsMm");
  });
}

OpalineStatus opalineOpenSequence(const char* pattern, const OpalineLoadOptions* options,
                                  OpalineSequence** sequence) {
  return guarded([&] {
    required(sequence, "sequence");
    *sequence = new OpalineSequence{
        {}, MeshSequence(&required(pattern, "pattern"), c::loadOptionsOf(options))};
  });
}

void opalineDestroySequence(OpalineSequence* sequence) {
  c::destroy(sequence);
}

OpalineStatus opalineSequenceNumbers(const OpalineSequence* sequence, int32_t* first,
                                     int32_t* last) {
  return guarded([&] {
    const MeshSequence& of = required(sequence, "sequence").sequence;
    required(first, "first") = of.firstNumber();
    required(last, "last") = of.lastNumber();
  });
}

OpalineStatus opalineSequenceScene(const OpalineSequence* sequence, OpalineScene** scene) {
  return guarded([&] { c::giveScene(required(sequence, "sequence").sequence.scene(), scene); });
}

OpalineStatus opalineReadSequence(const OpalineSequence* sequence, int32_t number,
                                  float* positionsMm, size_t vertexCount) {
  return guarded([&] {
    const MeshSequence& of = required(sequence, "sequence").sequence;
    if (number < of.firstNumber() || number > of.lastNumber()) {
      throw UsageError(fmt::format("There is no mesh {}: they go from {} to {}.", number,
                                   of.firstNumber(), of.lastNumber()));
    }
    std::vector<Vec3> positions;
    of.read(number, positions);
    c::give(positions, positionsMm, vertexCount, "positionsMm");
  });
}

}  // extern "C"
