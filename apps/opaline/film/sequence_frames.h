#pragma once

#include <memory>

#include "cli/motion_options.h"
#include "film/kept_positions.h"
#include "film/positions_ahead.h"
#include "opaline/sequence.h"

namespace opaline::app {

/// The number of the file that a frame shows: frame n is firstNumber() + n. Throws UsageError
/// beyond the last.
int numberOfFrame(const MeshSequence& sequence, int frame);

/// The same for a still at that time. It counts in frames at the usual speed, since a still has no
/// other.
int numberAt(const MeshSequence& sequence, double seconds);

/// The same, but the last file for all later times.
int nearestNumber(const MeshSequence& sequence, double seconds);

/// When a player shows a frame. Files of a sequence follow each other at the usual speed, whatever
/// that of the film.
double shownAt(const MeshSequence* sequence, const FrameRange& frames, int frame);

/// When the last file is shown, and when the next one would follow.
double lastSecond(const MeshSequence& sequence);
double secondsOf(const MeshSequence& sequence);

/// The files up to that number, `step` apart. Files that are kept already are not read.
PositionsAhead positionsOf(std::shared_ptr<const MeshSequence> sequence, int lastNumber,
                           int step = 1,
                           std::shared_ptr<KeptPositions> kept = std::make_shared<KeptPositions>());

}  // namespace opaline::app
