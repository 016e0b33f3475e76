// Surfels and their tree in storage buffers. Included by C++ and GLSL.
#ifndef OPALINE_SHARED_SURFELS_H
#define OPALINE_SHARED_SURFELS_H

#ifdef __cplusplus
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
namespace opaline::shared {
using uint = std::uint32_t;  // NOLINT(readability-identifier-naming): GLSL's word
using glm::vec3;
using glm::vec4;
#define OPALINE_SURFEL_CONSTANT constexpr std::uint32_t
#else
#define OPALINE_SURFEL_CONSTANT const uint
#endif

/// Whole numbers with this bit, when read as floats, are normal numbers, which no device changes.
OPALINE_SURFEL_CONSTANT setBit = 0x20000000u;

/// A part of a triangle, the same one however the triangle is deformed.
struct SurfelPiece {
  uint a;  // vertices of the triangle; these and the object have setBit
  uint b;
  uint c;
  uint object;
  float v0;  // barycentric coordinates of its three corners, for b and c
  float w0;
  float v1;
  float w1;
  float v2;
  float w2;
  float fraction;  // of the triangle's area; below 0 where an opaque body has a hole there
  float areaMm2;   // at rest
};

/// Light that enters through a piece is looked up at this many of its points (lib/piece.glsl).
OPALINE_SURFEL_CONSTANT pointsPerPiece = 3u;

/// Every surfel sends out light from this many points.
OPALINE_SURFEL_CONSTANT sourcesPerSurfel = 3u;

/// One of those points in this frame.
struct Source {
  vec4 positionArea;  // mm; mm² that it stands for
  vec4 flux;          // rgb: E·A that has entered
};

/// A node of the tree in this frame: what its sources send out, seen from far away. A channel
/// without flux has the others' centroid; a node without any has that of its area.
struct TreeNode {
  vec3 red;      // centroid of the red flux, mm
  float radius;  // mm; no source lies further from any of the three centroids
  vec3 green;
  uint link;  // see below
  vec3 blue;
  float
      momentXx;  // second moments of each channel's flux about its centroid, mean of all flux, mm²
  vec3 flux;     // rgb
  float momentYy;
  vec4 moments;  // zz xy xz yz
};

/// The box around all sources below a node in this frame, mm.
struct NodeBox {
  vec4 low;
  vec4 high;
};

/// A node's link. A leaf's has leafBit, its number of surfels less one from bit leafCountShift, and
/// its first surfel below. An inner node's is the index of the node after all below it. All have
/// setBit.
OPALINE_SURFEL_CONSTANT leafBit = 0x80000000u;
OPALINE_SURFEL_CONSTANT leafCountShift = 26u;

#ifdef __cplusplus
}  // namespace opaline::shared
#endif

#endif
