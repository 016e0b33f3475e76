#pragma once

/// Bodies that give way like jelly, in C; part of opaline/opaline_c.h.

#include "opaline/c/rendering.h"
#include "opaline/c/scenes.h"
#include "opaline/c/status.h"

OPALINE_C_BEGIN

/// See opaline/soft_body.h, which has the ranges.
typedef struct OpalineSoftBodyOptions {
  size_t size;  ///< sizeof(OpalineSoftBodyOptions)
  int32_t cells;
  float swingHz;
  float settleSeconds;
  float heldFraction;
  float reach;
} OpalineSoftBodyOptions;

/// Fills a struct whose size has been set.
OPALINE_API OpalineStatus opalineDefaultSoftBodyOptions(OpalineSoftBodyOptions* options);

/// It sets the positions of an object's vertices in a renderer.
typedef struct OpalineSoftBody OpalineSoftBody;

/// `scene` is the one that the renderer has; the object is at rest as its mesh has it there.
/// `options` may be NULL. It goes with the renderer at the latest. After opalineSetScene() it may
/// only be destroyed, which returns the object to its mesh.
OPALINE_API OpalineStatus opalineCreateSoftBody(OpalineRenderer* renderer,
                                                const OpalineScene* scene, size_t object,
                                                const OpalineSoftBodyOptions* options,
                                                OpalineSoftBody** body);
OPALINE_API void opalineDestroySoftBody(OpalineSoftBody* body);

/// Grabs what lies around a point, pulls it so that the point comes to another, lets go.
OPALINE_API OpalineStatus opalineGrabSoftBody(OpalineSoftBody* body, const float pointMm[3],
                                              float radiusMm);
OPALINE_API OpalineStatus opalinePullSoftBody(OpalineSoftBody* body, const float toMm[3]);
OPALINE_API OpalineStatus opalineReleaseSoftBody(OpalineSoftBody* body);

/// Goes on by a time, at most 0.2 s, and gives the next frame the positions.
OPALINE_API OpalineStatus opalineStepSoftBody(OpalineSoftBody* body, double seconds);

/// 1 while steps still change anything, as far as finished ones have told; else 0.
OPALINE_API OpalineStatus opalineSoftBodyMoves(const OpalineSoftBody* body, int32_t* moves);

OPALINE_C_END
