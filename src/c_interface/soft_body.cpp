#include "opaline/soft_body.h"

#include <utility>

#include "c_interface/handles.h"
#include "c_interface/status.h"
#include "c_interface/values.h"

namespace opaline::c {

namespace {

OpalineSoftBodyOptions given(const SoftBodyOptions& options) {
  return {0,
          options.cells,
          options.swingHz,
          options.settleSeconds,
          options.heldFraction,
          options.reach};
}

SoftBodyOptions softBodyOptionsOf(const OpalineSoftBodyOptions* from) {
  if (!from) return {};
  const OpalineSoftBodyOptions whole = wholeOf(from, given(SoftBodyOptions{}), "options");
  return {.cells = whole.cells,
          .swingHz = whole.swingHz,
          .settleSeconds = whole.settleSeconds,
          .heldFraction = whole.heldFraction,
          .reach = whole.reach};
}

SoftBody& bodyOf(OpalineSoftBody* body) {
  return required(body, "body").body;
}

}  // namespace
}  // namespace opaline::c

using namespace opaline;
using opaline::c::guarded;
using opaline::c::required;
using opaline::c::vectorOf;

extern "C" {

OpalineStatus opalineDefaultSoftBodyOptions(OpalineSoftBodyOptions* options) {
  return guarded([&] { c::give(c::given(SoftBodyOptions{}), options, "options"); });
}

OpalineStatus opalineCreateSoftBody(OpalineRenderer* renderer, const OpalineScene* scene,
                                    size_t object, const OpalineSoftBodyOptions* options,
                                    OpalineSoftBody** body) {
  return guarded([&] {
    required(body, "body");
    const Mesh& mesh = c::objectOf(scene, object).mesh;
    SoftBody made(required(renderer, "renderer").renderer, object, mesh.positionsMm, mesh.triangles,
                  c::softBodyOptionsOf(options));
    c::keep(new OpalineSoftBody{{}, renderer, std::move(made)}, &OpalineRenderer::softBodies, body);
  });
}

void opalineDestroySoftBody(OpalineSoftBody* body) {
  c::destroyPart(body, &OpalineRenderer::softBodies);
}

OpalineStatus opalineGrabSoftBody(OpalineSoftBody* body, const float pointMm[3], float radiusMm) {
  return guarded([&] { c::bodyOf(body).grab(vectorOf(pointMm, "pointMm"), radiusMm); });
}

OpalineStatus opalinePullSoftBody(OpalineSoftBody* body, const float toMm[3]) {
  return guarded([&] { c::bodyOf(body).pull(vectorOf(toMm, "toMm")); });
}

OpalineStatus opalineReleaseSoftBody(OpalineSoftBody* body) {
  return guarded([&] { c::bodyOf(body).release(); });
}

OpalineStatus opalineStepSoftBody(OpalineSoftBody* body, double seconds) {
  return guarded([&] { c::bodyOf(body).step(seconds); });
}

OpalineStatus opalineSoftBodyMoves(const OpalineSoftBody* body, int32_t* moves) {
  return guarded([&] { required(moves, "moves") = required(body, "body").body.moves() ? 1 : 0; });
}

}  // extern "C"
