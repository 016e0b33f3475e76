#pragma once

#include "opaline/sequence.h"

namespace opaline::app {

/// The number of the file that a frame shows: frame n is firstNumber() + n. Throws UsageError
/// beyond the last.
int numberOfFrame(const MeshSequence& sequence, int frame);

/// The same of a still at that time, at the usual speed, as a still has no other.
int numberAt(const MeshSequence& sequence, double seconds);

}  // namespace opaline::app
