#pragma once

#include <map>
#include <span>
#include <string>

#include "opaline/material.h"
#include "scene/formats.h"

namespace opaline::scene {

/// The materials of an OBJ file's .mtl files, by name: Kd, Ks, Ns, Ke, d, map_Kd, map_Ke and norm,
/// and Pr and Pm where a program wrote them. Files that cannot be read are left out, with a note.
std::map<std::string, OpaqueMaterial> readMtl(const Input& obj, std::span<const std::string> files);

}  // namespace opaline::scene
