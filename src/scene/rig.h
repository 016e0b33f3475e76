#pragma once

#include <string>

#include "scene/raw_scene.h"

namespace opaline::scene {

/// Gives every vertex of an object's mesh, as it stands now, a rig vertex of its own: for meshes
/// whose rig is made from themselves, before repair.
void startProvenance(RawMesh& mesh);

/// Brings a rig from the file's vertices to those of the repaired mesh; normals that were turned
/// with their triangles turn here too, and those that are zero become smooth. Throws Error, naming
/// `object`, for numbers that are not finite and for more of them than any machine should hold.
///
/// `room` is how many numbers the rest of the file may take; what this object takes is subtracted.
void alignRig(RawObject& object, const std::string& name, std::size_t& room);

/// Vectors and influences that the rigs of one file may take.
inline constexpr std::size_t mostRigNumbers = 40'000'000;

/// Appends the vertices of another rig of the same node with as many morph targets. Both follow
/// what they followed before: joints that differ stand beside each other, and what had none gets
/// the node as its joint.
void appendRig(Rig& rig, Rig&& part);

}  // namespace opaline::scene
