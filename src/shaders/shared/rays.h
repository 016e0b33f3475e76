// What rays are sent through, in storage and texel buffers. Included by C++ and GLSL.
#ifndef OPALINE_SHARED_RAYS_H
#define OPALINE_SHARED_RAYS_H

#ifdef __cplusplus
#include <glm/vec4.hpp>
namespace opaline::shared {
using glm::vec4;
#endif

/// A piece of a surfel where it lies in this frame, mm. A ray is let pass an edge on the outside by
/// about what rounding moves vertices, so that none slips between pieces: by the slack over the
/// length of the edge. For ray queries pieces are wider by as much instead.
struct RayPiece {
  vec4 cornerObject;  // the first corner; w the object's index
  vec4 cornerReach;   // the second; w mm: what a ray's origin, mm off 0, adds to the slack
  vec4 cornerSlack;   // the third; w mm²; far below 0 for what is never hit
};

/// A box around the pieces below a node of the tree, mm, wider than they by what rounding may do.
struct RayBox {
  vec4 lowLink;     // w: the node's link (shared/surfels.h), as bits
  vec4 highPieces;  // w: pieces a surfel
};

#ifdef __cplusplus
}  // namespace opaline::shared
#endif

#endif
