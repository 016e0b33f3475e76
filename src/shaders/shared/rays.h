// What rays are sent through, in storage and texel buffers. Included by C++ and GLSL.
#ifndef OPALINE_SHARED_RAYS_H
#define OPALINE_SHARED_RAYS_H

#ifdef __cplusplus
#include <glm/vec4.hpp>
namespace opaline::shared {
using glm::uvec4;
using glm::vec4;
#endif

/// A piece of a surfel where it lies in this frame, mm. A ray may pass an edge on the outside by
/// about as much as rounding moves vertices, so that none slips between pieces: by the slack over
/// the edge's length. For ray queries the pieces are that much wider instead.
struct RayPiece {
  vec4 cornerObject;  // the first corner; w: the object's index
  vec4 cornerReach;   // the second; w: slack per mm that a ray's origin lies off 0, mm
  vec4 cornerSlack;  // the third; w: the rest of the slack, mm²; far below 0 for what is never hit
};

/// Boxes are placed about the middle of the moved scene, in a unit that makes the furthest corner
/// some ten thousand. Half floats then hold them within a two-thousandth of their distance.
struct RayUnits {
  vec4 middleUnit;  // xyz mm; w: unit, mm
  vec4 pieces;      // x: pieces per surfel
};

/// A box around the pieces below a node of the tree, wider than they are by what rounding may do.
struct RayBox {
  uvec4 sidesLink;  // xyz: its low and high sides, half floats; w: the node's link
                    // (shared/surfels.h)
};

#ifdef __cplusplus
}  // namespace opaline::shared
#endif

#endif
