#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "bssrdf/profile.h"
#include "shaders/shared/medium.h"

namespace opaline::passes {

/// What is asked of the pattern. Gong et al. 2008, Figure 5.
struct PatternShape {
  int nearRings = 4;         ///< the near block has (2·nearRings+1)² samples, the centre included
  double nearSpacingMm = 0;  ///< between near samples
  double farDistanceMm = 0;  ///< of the eight far samples from the centre
};

/// The pattern on a map of texels.
struct PatternExtent {
  int nearRings = 0;
  int spacing = 1;   ///< between near samples, texels
  int distance = 1;  ///< of the far samples from the centre, texels
  int cell = 1;      ///< edge of the cells over which far samples want means, texels

  /// Texels that near and far samples may lie away from the centre, their filters included.
  int nearReach() const;
  int farReach() const;
};

/// Rounds to whole texels, keeps the far samples off the block and the whole pattern from being
/// larger than a disc of the object's area.
PatternExtent patternExtent(const PatternShape& shape, double texelMm, double objectAreaMm2);

/// The largest pattern of that kind that stays within these reaches, texels.
PatternExtent fitted(PatternExtent extent, int nearReach, int farReach);

/// The entries of one medium, see shared::PatternEntry, and the number of near samples among them;
/// eight far ones follow.
struct PatternMask {
  std::vector<shared::PatternEntry> entries;
  std::uint32_t nearSamples = 0;
};

/// Offsets and weights of the samples. On a plane under uniform light every near sample gives
/// exactly what its square cell reflects, and the eight far samples together what the ring gives that
/// lies around the block and reaches as far beyond them as they lie beyond the block. `farMapSize` is
/// the edge, in texels, of the map in whose [0,1]² the far samples are placed.
PatternMask makePatternMask(const std::array<bssrdf::Profile, 3>& profiles,
                            const PatternExtent& extent, double texelMm, int farMapSize);

}  // namespace opaline::passes
