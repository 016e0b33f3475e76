#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "opaline/renderer.h"
#include "opaline/scene.h"
#include "paper/technique.h"
#include "passes/boundary/cluster_pass.h"
#include "passes/products.h"
#include "renderer/scene/division.h"
#include "renderer/scene/insides.h"
#include "renderer/scene/texture_packer.h"
#include "scene/mesh/merged_mesh.h"
#include "shaders/shared/opaque.h"

namespace opaline::gpu {
class Device;
}

namespace opaline {

/// What sums need of a scene beside its mesh.
struct SceneNeeds {
  std::optional<int> maxSurfels;   ///< surfels and their tree
  std::optional<int> maxClusters;  ///< clusters of surfels, for boundary transport
  bool rays = false;               ///< where there are no clusters; wants surfels

  bool operator==(const SceneNeeds&) const = default;
};

/// Where the surfels of an object's body lie among all.
struct SurfelsOfObject {
  std::uint32_t firstObject = 0;  ///< of those that are the body
  double areaMm2 = 0;             ///< of the body at rest
  std::uint32_t first = 0;
  std::uint32_t count = 0;           ///< without those of its lining
  std::uint32_t root = 0;            ///< among the tree's nodes
  std::uint32_t endNode = 0;         ///< the node after its tree
  std::uint32_t liningEndNode = 0;   ///< and after that of its lining, which follows
  double sourceSpacingMm = 0;        ///< root of the mean area that a source stands for
  bool coarse = false;               ///< sources are too far apart for the medium
  std::uint32_t clusterRoot = 0;     ///< among the nodes of clusters
  std::uint32_t clusterEndNode = 0;  ///< the node after its tree
  bool hasInside = false;            ///< in some part; only found out where there are clusters
  std::uint32_t backClusters = 0;    ///< of its back, which follow those of its front
};

/// Of an object at rest.
struct SizeOfObject {
  double areaMm2 = 0;
  double meanEdgeMm = 0;        ///< each triangle counted once
  double meanEdgeByAreaMm = 0;  ///< each by its area
};

/// A scene on the device: what depends on the rest pose alone. Objects are laid end to end.
struct SceneResources {
  const scene::MergedMesh* merged = nullptr;  ///< that it was made from
  SceneNeeds needs;                           ///< that it was made for
  passes::DeformedMesh mesh;
  passes::Surfels surfels;    ///< empty where none are needed
  passes::RayHierarchy rays;  ///< where clusters or rays are needed, or surfels have been asked for
  passes::Clusters clusters;  ///< these two where clusters are needed
  passes::Solver solver;
  passes::OpaqueTables opaque;
  std::vector<SurfelsOfObject> surfelsOfObject;  ///< one an object, where there are surfels
  std::uint32_t objects = 0;
  std::uint32_t triangles = 0;
  std::uint32_t castingTriangles = 0;  ///< that cast shadows, and come first
  /// The different ones. Of those that clips change, each of which is an object's own, the finest.
  std::vector<Medium> media;
  std::vector<Medium> mediaInClips;                           ///< all that clips make of these
  std::vector<std::optional<OpaqueMaterial>> opaqueOfMedium;  ///< that has its place among these
  std::vector<std::optional<Paint>> paintOfMedium;            ///< on those
  std::vector<std::optional<TranslucentSurface>> surfaceOfMedium;  ///< of translucent ones
  std::vector<std::uint32_t> materialOfMedium;  ///< among the next, where it has one
  std::vector<OpaqueMaterial> materials;  ///< the different ones, and paints and surfaces of media
                                          ///< as such, in `opaque`
  std::optional<TexturePacker> textures;  ///< of these
  std::vector<shared::OpaqueData> materialsOnHost;  ///< what `opaque` has of them
  std::vector<std::uint32_t> materialOfObject;      ///< where it has one, else 0
  std::vector<std::uint32_t> mediumOfObject;
  std::vector<SizeOfObject> sizeOfObject;
  Insides insides;  ///< these two where clusters are needed
  surfels::Linings linings;
  std::vector<bool> letsLightThrough;    ///< of objects, in some clip
  DivisionOrder divided;                 ///< that the surfels were made for
  std::optional<paper::FlatScene> flat;  ///< none until the paper's map is asked for

  /// Whether any object has, so that boundary transport is of use.
  bool hasInside() const;
  bool isOpaque(std::size_t object) const;
  bool hasOpaque() const;
  bool anyLetsLightThrough() const;
  bool isPainted(std::size_t object) const;
  bool hasOwnNormals(std::size_t object) const;
};

/// `merged` is of the scene and outlives the resources. Notes go to `log`.
SceneResources makeSceneResources(gpu::Device& device, const Scene& scene,
                                  const scene::MergedMesh& merged, const SceneNeeds& needs,
                                  const LogCallback& log = {});

/// Takes up what the scene's media and materials have become; the surface stays divided as it is.
void takeMedia(gpu::Device& device, const Scene& scene, SceneResources& resources);

/// How finely the surface should be divided for them.
DivisionOrder orderFor(const gpu::Device& device, const Scene& scene,
                       const SceneResources& resources);

/// Divides the surface anew.
void takeDivision(gpu::Device& device, const Division& division, SceneResources& resources);

/// What the paper's method reads of them.
paper::RestScene restSceneOf(const SceneResources& resources);

/// Whether light is summed well enough at an object's vertices (Gong et al. 2008): edges are no
/// longer than a mean free path, and no large part of the surface has far longer ones.
bool wantsVertices(const SceneResources& resources, std::size_t object);

/// Says of which objects sums at vertices, where those are asked for, show next to nothing.
void noteSite(const Scene& scene, const SceneResources& resources, Site site,
              const LogCallback& log);

}  // namespace opaline
