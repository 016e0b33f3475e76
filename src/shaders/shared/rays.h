// What rays are sent through, in storage and texel buffers. Included by C++ and GLSL.
#ifndef OPALINE_SHARED_RAYS_H
#define OPALINE_SHARED_RAYS_H

#ifdef __cplusplus
#include <glm/vec4.hpp>
namespace opaline::shared {
using glm::uvec4;
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

/// Boxes stand around the middle of the moved scene, in a unit that makes the furthest corner some
/// ten thousand, so that half floats hold them: within a two-thousandth of how far off they are.
struct RayUnits {
  vec4 middleUnit;  // xyz mm; w: unit, mm
  vec4 pieces;      // x: pieces a surfel
};

/// A box around the pieces below a node of the tree, wider than they by what rounding may do.
struct RayBox {
  uvec4 sidesLink;  // xyz: its low side and its high one, half floats; w: the node's link
                    // (shared/surfels.h)
};

#ifdef __cplusplus
}  // namespace opaline::shared
#endif

#endif
