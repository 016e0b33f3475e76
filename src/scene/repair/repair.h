#pragma once

#include <string>
#include <vector>

#include "opaline/scene.h"
#include "scene/raw_scene.h"

namespace opaline::scene {

/// Mends a mesh whose indices are in range and returns what was mended, only counts above 0:
///   unused vertices             that no triangle names
///   degenerate triangles        a repeated corner or no area, and polygons of fewer than three
///                               corners
///   vertices beside their seam  on an open edge, by rounding; now where the other side has them
///   duplicate vertices          same point of the surface, same normal, same tag; now one vertex
///   duplicate faces             same three places in the same turn, or on one surface in any turn
///   inconsistent orientation    triangles turned to agree with the rest of their component
///   inward orientation          triangles of components turned as a whole
///   non-manifold edges          with more than two triangles or two that cannot agree; cut apart
///   unusable normals            zero or not finite; now smooth
/// Missing normals become smooth ones. Throws Error, naming `object`, for a position that is not
/// finite and when no triangle is left.
std::vector<Repair> repairMesh(RawMesh& mesh, const std::string& object);

/// Adds to the entry of the same name, or appends a new one.
void addRepair(std::vector<Repair>& repairs, const std::string& what, std::size_t count);

}  // namespace opaline::scene
