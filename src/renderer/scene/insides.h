#pragma once

#include <vector>

#include "opaline/log.h"
#include "opaline/scene.h"
#include "scene/mesh/merged_mesh.h"
#include "surfels/linings.h"

namespace opaline {

/// What has an inside; only known where there are clusters.
struct Insides {
  std::vector<bool> objectHasInside;      ///< it is translucent, and some part of its body closed
  std::vector<bool> objectIsOpen;         ///< some part of its body is
  std::vector<bool> triangleHasInside{};  ///< of all objects: the part that it is of is closed
};

/// Notes to `log` what is translucent and open.
Insides findInsides(const Scene& scene, const scene::MergedMesh& merged, const LogCallback& log);

/// Of opaque things in translucent ones. Notes what lies in one, but cannot end its light.
surfels::Linings findLinings(const Scene& scene, const scene::MergedMesh& merged,
                             const Insides& insides, const LogCallback& log);

}  // namespace opaline
