// What moves vertices. Included by C++ and GLSL; every member of a storage structure is a scalar,
// so that the layouts agree.
#ifndef OPALINE_SHARED_DEFORM_H
#define OPALINE_SHARED_DEFORM_H

#ifdef __cplusplus
#include <cstdint>
#include <glm/vec4.hpp>
namespace opaline::shared {
using uint = std::uint32_t;  // NOLINT(readability-identifier-naming): GLSL's word
using glm::uvec4;
using glm::vec4;
#define OPALINE_CONSTANT constexpr std::uint32_t
#else
#define OPALINE_CONSTANT const uint
#endif

OPALINE_CONSTANT maxDeformers = 8;

/// A vertex before anything moves it: in its rig's space, or in mm where it has none.
struct RestVertex {
  float x;
  float y;
  float z;
  uint object;
  float normalX;
  float normalY;
  float normalZ;
  uint unused;
};

/// What a morph target adds to one vertex at weight 1.
struct MorphDelta {
  uint weight;  // index among all weights
  float x;
  float y;
  float z;
  float normalX;
  float normalY;
  float normalZ;
};

/// One joint that pulls at a vertex.
struct JointInfluence {
  uint matrix;  // index among all matrices
  float weight;
};

/// The two vertices that follow a vertex in one of its triangles.
struct TriangleEdge {
  uint next;
  uint last;
};

/// An object's state in this frame.
struct ObjectMotion {
  uint replaced;         // 1: its positions are given
  uint normalsFromMesh;  // 1: its normals are made from its triangles
  float side;     // -1 where it is mirrored relative to rest, which reverses its triangles; else 1
  uint isGround;  // 1: deformers leave it alone, and the box around everything leaves it out
};

/// A deformer; see DeformerKind in motion.h.
struct DeformerData {
  vec4 box;     // x: middle x; y: bottom; z: middle z; w: height H, mm
  vec4 amount;  // x: amount at this time; y: phase in periods; z: diagonal D, mm
  uvec4 kind;   // x
};

struct DeformFrame {
  uvec4 counts;  // x: vertices; y: deformers; z: 1 with morph deltas; w: 1 with influences
  vec4 middle;   // xyz: of the rest pose, mm; w: how far from it vertices may move, mm
  DeformerData deformers[maxDeformers];
};

#ifdef __cplusplus
}  // namespace opaline::shared
#endif

#endif
