#pragma once

#include <string>

#include "scene/raw_scene.h"

namespace opaline::scene {

/// Gives every vertex of an object's mesh, as it is before repair, its own rig vertex. For meshes
/// whose rig is made from the mesh itself.
void startProvenance(RawMesh& mesh);

/// Maps a rig from the file's vertices to those of the repaired mesh. Normals that were turned with
/// their triangles turn here too; zero ones become smooth. Throws Error, naming `object`, for
/// numbers that are not finite or that are more than any machine should hold.
///
/// `room` is how many numbers the file may still use; this object's are subtracted.
void alignRig(RawObject& object, const std::string& name, std::size_t& room);

/// Most vectors and influences that the rigs of one file may use.
inline constexpr std::size_t mostRigNumbers = 40'000'000;

/// Appends the vertices of another rig of the same node with as many morph targets. Both keep
/// following what they followed before: the joints of both are kept, and a part without joints gets
/// the node as its joint.
void appendRig(Rig& rig, Rig&& part);

}  // namespace opaline::scene
