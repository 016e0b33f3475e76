#pragma once

#include "core/rest_surface.h"
#include "opaline/atlas.h"

namespace opaline::atlas {

using opaline::Atlas;

/// Flattens any set of triangles; charts never cross objects, and without a table of these all is
/// one. Never fails for finite positions and valid indices. AtlasVertex::vertex is an index into
/// RestSurface::positionsMm.
Atlas makeAtlas(const core::RestSurface& surface, const AtlasOptions& options = {});

}  // namespace opaline::atlas
