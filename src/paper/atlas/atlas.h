#pragma once

#include "core/rest_surface.h"
#include "opaline/atlas.h"

namespace opaline::atlas {

using opaline::Atlas;

/// Flattens any set of triangles. Charts never cross objects; without a table of objects all
/// triangles are one. It never fails for finite positions and valid indices. AtlasVertex::vertex is
/// an index into RestSurface::positionsMm.
Atlas makeAtlas(const core::RestSurface& surface, const AtlasOptions& options = {});

}  // namespace opaline::atlas
