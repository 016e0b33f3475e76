#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "opaline/material.h"
#include "opaline/scene.h"
#include "scene/formats.h"

namespace opaline::scene {

/// The files that the rest of a line `mtllib` names. It is one name with blanks if there is such a
/// file, or if no word of it is a file; otherwise its words are names.
std::vector<std::string> materialFilesOf(const Input& obj, const std::string& line);

struct MtlMaterial {
  OpaqueMaterial shown;
  std::set<std::string> notShown;  ///< what the file says of it that no picture shows
};

/// By name.
using MtlMaterials = std::map<std::string, MtlMaterial>;

/// The materials of an OBJ file's .mtl files: Kd, Ks, Ns, Ke, d, map_Kd, map_Ke and norm, and Pr
/// and Pm where a program wrote them. Files that cannot be read are left out, with a note. So are
/// pictures, which are also counted in `unreadable`.
MtlMaterials readMtl(const Input& obj, std::span<const std::string> files,
                     std::vector<NotShown>& unreadable);

}  // namespace opaline::scene
