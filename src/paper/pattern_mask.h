#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "bssrdf/profile.h"
#include "paper/shaders/shared/pattern.h"

namespace opaline::paper {

/// What is asked of the pattern (Gong et al. 2008, Figure 5).
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
  double outer = 1;  ///< radius to which the far samples' ring reaches, texels
  int cell = 1;      ///< edge of the cells over which far samples want means, texels

  /// Radius of the disc that is as large as the near block, texels.
  double blockRadius() const;
  /// How far from the centre near samples and the filter there may reach, texels.
  int nearReach() const;
};

/// Rounds to whole texels, keeps the far samples off the block, and keeps both small beside the
/// object. The ring reaches as far beyond the wanted distance as that lies beyond the block, but no
/// further than a disc of the object's area.
PatternExtent patternExtent(const PatternShape& shape, double texelMm, double objectAreaMm2);

/// The largest pattern of that kind whose near samples stay within that reach, texels.
PatternExtent fitted(PatternExtent extent, int nearReach);

/// The entries of one medium, see shared::PatternEntry, and the number of near samples among them.
struct PatternMask {
  std::vector<shared::PatternEntry> entries;
  std::uint32_t nearSamples = 0;
  double nearSquareMm2 = 0;  ///< mean square radius of what a near sample stands for
  double farSquareMm2 = 0;   ///< the same for a far one
};

/// Offsets and weights of the samples. On a plane under uniform light every near sample gives
/// exactly what its square cell reflects. The eight far samples together give what the ring around
/// the block does, which reaches as far beyond them as they lie beyond the block. Where a profile
/// falls steeply the distance shrinks rather than the weight grows, because folds would make sparks
/// of large weights.
PatternMask makePatternMask(const std::array<bssrdf::Profile, 3>& profiles,
                            const PatternExtent& extent, double texelMm);

}  // namespace opaline::paper
