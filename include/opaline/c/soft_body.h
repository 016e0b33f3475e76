#pragma once

/// Bodies that give way like jelly, in C; part of opaline/opaline_c.h.

#include "opaline/c/rendering.h"
#include "opaline/c/scenes.h"
#include "opaline/c/status.h"

OPALINE_C_BEGIN

/// The properties of a soft body; opaline/soft_body.h explains them and has their ranges.
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

/// A soft body, which sets the positions of an object's vertices in a renderer.
typedef struct OpalineSoftBody OpalineSoftBody;

/// `scene` is the one that the renderer has; the object's mesh there is its shape at rest.
/// `options` may be NULL. Destroying the renderer destroys the body, too. After opalineSetScene()
/// it may only be destroyed, which returns the object to its mesh.
OPALINE_API OpalineStatus opalineCreateSoftBody(OpalineRenderer* renderer,
                                                const OpalineScene* scene, size_t object,
                                                const OpalineSoftBodyOptions* options,
                                                OpalineSoftBody** body);
OPALINE_API void opalineDestroySoftBody(OpalineSoftBody* body);

/// Grab what lies around a point, pull it so that the point moves to another, and release it.
OPALINE_API OpalineStatus opalineGrabSoftBody(OpalineSoftBody* body, const float pointMm[3],
                                              float radiusMm);
OPALINE_API OpalineStatus opalinePullSoftBody(OpalineSoftBody* body, const float toMm[3]);
OPALINE_API OpalineStatus opalineReleaseSoftBody(OpalineSoftBody* body);

/// Advances time by at most 0.2 s and gives the next frame the new positions.
OPALINE_API OpalineStatus opalineStepSoftBody(OpalineSoftBody* body, double seconds);

/// 1 while steps still change anything, judged by finished steps; else 0.
OPALINE_API OpalineStatus opalineSoftBodyMoves(const OpalineSoftBody* body, int32_t* moves);

OPALINE_C_END
