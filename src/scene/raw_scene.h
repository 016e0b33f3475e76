#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "opaline/scene.h"
#include "scene/vertex_attributes.h"

namespace opaline::scene {

/// Where a vertex comes from, and what became of its normal.
struct Provenance {
  std::uint32_t vertex = 0;   ///< index in the file, and thus in the object's rig and attributes
  bool normalTurned = false;  ///< turned with its triangles
  bool normalSmooth = false;  ///< replaced, as the file's was unusable
};

/// A mesh as a file gives it: in range, but neither repaired nor scaled nor oriented.
struct RawMesh {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;  ///< empty, or one per position, any length
  /// Vertices with different tags are different even where position and normal agree. Empty: all
  /// tags are equal.
  std::vector<std::uint64_t> tags;
  std::vector<Provenance> provenance;  ///< empty, or one per position: kept up through all repairs
  std::vector<Triangle> triangles;
  std::size_t badPolygons = 0;    ///< faces that never became a triangle: fewer than three corners
  std::size_t polygons = 0;       ///< faces as the file has them, where it has polygons
  std::uint64_t polygonHash = 0;  ///< of their corners
  bool facetted = false;          ///< as in Mesh
};

struct RawObject {
  std::string name;
  RawMesh mesh;
  Medium medium;
  /// As in Object. Until alignRig() its vertices are the file's, which `mesh.provenance` names, and
  /// normals may be zero.
  std::optional<Rig> rig;
  std::optional<Paint> paint;  ///< as in Object, like the next two
  std::optional<TranslucentSurface> surface;
  std::optional<OpaqueMaterial> opaque;
  VertexAttributes attributes;  ///< of the file's vertices, until alignAttributes()
};

/// What a file holds, in the file's unit, before repair, scale and defaults.
struct RawScene {
  std::vector<RawObject> objects;
  Lighting lighting;
  bool hasLights = false;
  std::optional<Camera> camera;
  bool cameraChosen = false;  ///< as in Scene
  std::vector<Node> nodes;
  std::vector<Clip> clips;
  std::vector<ClipChanges> changes;  ///< as in Scene
  std::vector<Deformer> deformers;
  std::vector<NotShown> notShown;
  std::vector<NotShown> unreadable;  ///< also not shown; a note has said of each why
  bool hasMediaPerMetre = false;     ///< the file gives mean free paths
  std::optional<double> mmPerUnit;   ///< unknown for formats without a unit
};

}  // namespace opaline::scene
