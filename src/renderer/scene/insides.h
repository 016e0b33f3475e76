#pragma once

#include <vector>

#include "opaline/log.h"
#include "opaline/scene.h"
#include "scene/mesh/merged_mesh.h"
#include "surfels/linings.h"
#include "surfels/overlaps.h"

namespace opaline {

/// What has an inside; only known if there are clusters.
struct Insides {
  std::vector<bool> objectHasInside;  ///< it is translucent, and some part of its body is closed
  std::vector<bool> objectIsOpen;     ///< some part of its body is open
  std::vector<bool> triangleHasInside{};  ///< of all objects: its part of the surface is closed
};

/// Finds insides and logs which translucent objects are open.
Insides findInsides(const Scene& scene, const scene::MergedMesh& merged, const LogCallback& log);

/// What lies within translucent bodies; only known if there are clusters.
struct Within {
  surfels::Linings linings;    ///< surfaces of opaque things
  surfels::Overlaps overlaps;  ///< of parts of one body, unless surfels cover these too
  bool overlapAtRest = false;  ///< some do at rest
  std::vector<bool> isPorous;  ///< by object: it is opaque and has holes or lets light through
};

/// Finds it. Logs things that lie in a body but cannot end its light. Parts that clips bend may
/// move apart and have no overlaps. `keepsOverlaps`: as in SceneNeeds.
Within findWithin(const Scene& scene, const scene::MergedMesh& merged, const Insides& insides,
                  bool keepsOverlaps, const LogCallback& log);

/// Whether it still holds after edits of materials: a solid may have become a sheet, or the
/// reverse.
bool stillHolds(const Within& within, const Scene& scene);

}  // namespace opaline
