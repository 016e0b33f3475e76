#pragma once

#include "paper/atlas/atlas.h"
#include "paper/atlas/topology.h"

namespace opaline::atlas {

/// Fills in mmPerUnit and the statistics that follow from the geometry: coverage of a map of that
/// many texels along an edge, and distortion of area.
void measure(const Topology& topology, int mapSize, Atlas& atlas);

}  // namespace opaline::atlas
