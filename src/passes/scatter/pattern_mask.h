#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "bssrdf/profile.h"
#include "shaders/shared/medium.h"

namespace opaline::passes {

/// Shape of the pattern. Gong et al. 2008, Figure 5.
struct PatternShape {
  int nearRings = 4;        ///< the near block has (2·nearRings+1)² samples, the centre included
  double nearSpacingMm = 0; ///< between near samples, rounded to whole texels
  double farDistanceMm = 0; ///< of the eight far samples, rounded likewise and kept off the block
  double texelMm = 0;       ///< edge of a texel in the rest pose
  int mapSize = 0;          ///< no offset is larger
};

/// The entries of one medium, see shared::PatternEntry, and the number of samples among them.
struct PatternMask {
  std::vector<shared::PatternEntry> entries;
  std::uint32_t samples = 0;
};

/// Offsets and weights of the samples. On a plane under uniform light every near sample gives
/// exactly what its square cell reflects, and the eight far samples together what the ring gives that
/// lies around the block and reaches as far beyond them as they lie beyond the block.
PatternMask makePatternMask(const std::array<bssrdf::Profile, 3>& profiles,
                            const PatternShape& shape);

}  // namespace opaline::passes
