// The pattern in uniform blocks. Included by C++ and GLSL.
#ifndef OPALINE_PAPER_SHARED_PATTERN_H
#define OPALINE_PAPER_SHARED_PATTERN_H

#ifdef __cplusplus
#include <cstdint>
#include <glm/vec4.hpp>
namespace opaline::shared {
using uint = std::uint32_t;  // NOLINT(readability-identifier-naming): GLSL's word
using glm::vec4;
#define OPALINE_PATTERN_CONSTANT constexpr std::uint32_t
#else
#define OPALINE_PATTERN_CONSTANT const uint
#endif

/// The head of one medium's pattern.
struct PatternHead {
  float nearSquareMm2;  // mean square radius of the piece of surface that a near sample stands for
  float farSquareMm2;   // the same for a far one
  uint nearSamples;
  uint unused;
};

/// The pattern of Gong et al. 2008, Figure 5, as a list of entries. The first two are about the
/// centre: [0] rgb: reflectance of its cell, a: area of a texel in the rest pose, mm²; [1] rgb: its
/// logarithmic derivative by area, a: number of texels in the cell of a near sample. Then follow
/// the near samples, rgb: square of the part of its distance at which a sample's piece of surface
/// reflects as much as in the mean, a: its offset in texels, two signed 16-bit integers (x low, y
/// high) as a float's bits. The next entry is about the eight far samples, rgb: the same, a: number
/// of texels that one stands for.
struct PatternEntry {
  vec4 value;
};

/// A near block of 31² samples and the other entries. With the head they fill what every device
/// reads as one uniform block.
OPALINE_PATTERN_CONSTANT maxPatternEntries = 31 * 31 + 2;

#ifdef __cplusplus
static_assert(sizeof(PatternHead) == sizeof(PatternEntry));
static_assert(sizeof(PatternHead) + sizeof(PatternEntry) * maxPatternEntries <= 16384);
}  // namespace opaline::shared
#endif

#endif
