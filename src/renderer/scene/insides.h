#pragma once

#include <vector>

#include "opaline/log.h"
#include "opaline/scene.h"
#include "scene/mesh/merged_mesh.h"
#include "surfels/linings.h"

namespace opaline {

/// What has an inside; only known if there are clusters.
struct Insides {
  std::vector<bool> objectHasInside;  ///< it is translucent, and some part of its body is closed
  std::vector<bool> objectIsOpen;     ///< some part of its body is open
  std::vector<bool> triangleHasInside{};  ///< of all objects: its part of the surface is closed
};

/// Finds insides and logs which translucent objects are open.
Insides findInsides(const Scene& scene, const scene::MergedMesh& merged, const LogCallback& log);

/// Finds the surfaces of opaque things in translucent ones. Logs things that lie in one but cannot
/// end its light.
surfels::Linings findLinings(const Scene& scene, const scene::MergedMesh& merged,
                             const Insides& insides, const LogCallback& log);

}  // namespace opaline
