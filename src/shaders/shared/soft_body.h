// A soft body's cage in storage buffers. Included by C++ and GLSL. Lengths are in cells, places
// from the cage's origin.
#ifndef OPALINE_SHARED_SOFT_BODY_H
#define OPALINE_SHARED_SOFT_BODY_H

#ifdef __cplusplus
#include <cstdint>
#include <glm/vec4.hpp>
namespace opaline::shared {
using uint = std::uint32_t;  // NOLINT(readability-identifier-naming): GLSL's word
using glm::vec4;
#define OPALINE_SOFT_CONSTANT constexpr std::uint32_t
#else
#define OPALINE_SOFT_CONSTANT const uint
#endif

/// What 16 KiB of shared memory hold, the least that every device has.
OPALINE_SOFT_CONSTANT maxSoftNodes = 1360u;
OPALINE_SOFT_CONSTANT softGroupSize = 64u;

/// A corner of a cell is its node and, in bits 16 and above, the number of cells around that node,
/// which is its mass in eighths of a cell's. 0 means that it is held.
OPALINE_SOFT_CONSTANT softMassShift = 16u;

/// Cells of one colour have no corner in common.
OPALINE_SOFT_CONSTANT softColours = 8u;

/// A corner of cells, at rest.
struct SoftNode {
  float x;
  float y;
  float z;
  uint held;  // 1: it stands still
};

/// How far a node is from its rest, and how far it will be in a substep that nothing disturbs.
struct SoftMotion {
  float shiftX;
  float shiftY;
  float shiftZ;
  float aheadX;
  float aheadY;
  float aheadZ;
};

/// What a step does.
struct SoftStep {
  vec4 grab;         // xyz: a place to take hold of; w: 1 / radius, or 0 to take none
  vec4 goal;         // xyz: how far the hold is to go; w: part of that way per substep
  float shear;       // 8 μ h² / (ρ a²)
  float compliance;  // of a cell's volume, less what one iteration makes up for; ρ a² / (h² Pa)
  float anchor;      // (ω h)² of the pull to rest
  float grip;        // (ω h)² of the hold
  float damping;     // what is left of a velocity after a substep
  float reach;       // farthest from its rest that a held node is asked to go
  float stillStep;   // largest of a node in a substep where nothing moves any more
  float stillShift;  // largest of a node where all are taken to be at rest
  float strayShift;  // a larger one of any node is no rest, if the body stands still there
  float strayFrom;   // substeps that it stands still there before it is led home
  float homePerSubstep;  // part of the pull home that every substep adds
  float homeMost;        // (ω h)² of the whole pull home
  uint nodeCount;
  uint substeps;
  uint holds;                            // 1: something is held
  uint firstOfColour[softColours + 1u];  // cell
};

/// What a step reports back.
struct SoftReport {
  float holdX;  // how far the hold has gone
  float holdY;
  float holdZ;
  uint still;     // 1: nothing moves
  float strayed;  // substeps in which the body stood still away from its rest, or was led home
  float unused[3];
};

#ifdef __cplusplus
}  // namespace opaline::shared
#endif

#endif
