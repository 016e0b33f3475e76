#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "opaline/renderer.h"
#include "opaline/scene.h"
#include "paper/technique.h"
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

/// What sums need of a scene besides its mesh.
struct SceneNeeds {
  std::optional<int> maxSurfels;   ///< surfels and their tree
  std::optional<int> maxClusters;  ///< clusters of surfels, for boundary transport
  bool rays = false;               ///< without clusters; needs surfels
  bool keepsOverlaps = false;      ///< surfels on what lies within other parts of a body too

  bool operator==(const SceneNeeds&) const = default;
};

/// Where the surfels of an object's body lie among all.
struct SurfelsOfObject {
  std::uint32_t firstObject = 0;  ///< first of the objects that form the body
  double areaMm2 = 0;             ///< of the body at rest
  std::uint32_t first = 0;
  std::uint32_t count = 0;           ///< number, without those of its lining
  std::uint32_t root = 0;            ///< among the tree's nodes
  std::uint32_t endNode = 0;         ///< the node after its tree
  std::uint32_t liningEndNode = 0;   ///< the node after the tree of its lining, which follows
  double sourceSpacingMm = 0;        ///< root of the mean area that a source stands for
  bool coarse = false;               ///< sources are too far apart for the medium
  std::uint32_t clusterRoot = 0;     ///< among the nodes of clusters
  std::uint32_t clusterEndNode = 0;  ///< the node after its tree
  bool hasInside = false;            ///< in some part; only known if there are clusters
  std::uint32_t backClusters = 0;  ///< number of those of its back, which follow those of its front
};

/// Sizes of an object at rest.
struct SizeOfObject {
  double areaMm2 = 0;
  double meanEdgeMm = 0;        ///< each triangle counted once
  double meanEdgeByAreaMm = 0;  ///< each weighted by its area
};

/// A scene on the device: what depends on the rest pose alone. Objects follow each other.
struct SceneResources {
  const scene::MergedMesh* merged = nullptr;  ///< what it was made from
  SceneNeeds needs;                           ///< what it was made for
  passes::DeformedMesh mesh;
  passes::Surfels surfels;    ///< empty if none are needed
  passes::RayHierarchy rays;  ///< if clusters or rays are needed, or surfels have been shown
  passes::Clusters clusters;  ///< this and the next only if clusters are needed
  passes::Solver solver;
  passes::OpaqueTables opaque;
  std::vector<SurfelsOfObject> surfelsOfObject;  ///< one per object, if there are surfels
  std::uint32_t objects = 0;
  std::uint32_t triangles = 0;
  std::uint32_t castingTriangles = 0;  ///< number of those that cast shadows, which come first
  /// The distinct media. Those that clips change belong to one object each; their entry is the
  /// finest.
  std::vector<Medium> media;
  std::vector<Medium> mediaInClips;  ///< all media that clips turn these into
  /// An opaque material that takes the place of a medium.
  std::vector<std::optional<OpaqueMaterial>> opaqueOfMedium;
  std::vector<std::optional<Paint>> paintOfMedium;                 ///< paint on each medium
  std::vector<std::optional<TranslucentSurface>> surfaceOfMedium;  ///< of each translucent medium
  std::vector<std::uint32_t> materialOfMedium;  ///< index into `materials`, if it has one
  std::vector<OpaqueMaterial> materials;  ///< the distinct materials in `opaque`, including paints
                                          ///< and surfaces of media
  std::optional<TexturePacker> textures;  ///< of these materials
  std::vector<shared::OpaqueData> materialsOnHost;  ///< as in `opaque`
  std::vector<std::uint32_t> materialOfObject;      ///< index into `materials`; 0 if it has none
  std::vector<std::uint32_t> mediumOfObject;
  std::vector<SizeOfObject> sizeOfObject;
  Insides insides;  ///< this and the next only if clusters are needed
  Within within;
  std::vector<bool> letsLightThrough;    ///< by object, in some clip
  DivisionOrder divided;                 ///< what the surfels were made for
  std::optional<paper::FlatScene> flat;  ///< none until the paper's map is needed

  /// Whether any object has an inside, so that boundary transport makes sense.
  bool hasInside() const;
  bool isOpaque(std::size_t object) const;
  bool hasOpaque() const;
  bool anyLetsLightThrough() const;
  bool isPainted(std::size_t object) const;
  bool hasOwnNormals(std::size_t object) const;
};

/// `merged` belongs to the scene and outlives the resources. Notes go to `log`.
SceneResources makeSceneResources(gpu::Device& device, const Scene& scene,
                                  const scene::MergedMesh& merged, const SceneNeeds& needs,
                                  const LogCallback& log = {});

/// Takes over the scene's changed media and materials. The division of the surface stays.
void takeMedia(gpu::Device& device, const Scene& scene, SceneResources& resources);

/// How finely the surface should be divided for the current media.
DivisionOrder orderFor(const gpu::Device& device, const Scene& scene,
                       const SceneResources& resources);

/// Takes over a new division of the surface.
void takeDivision(gpu::Device& device, const Division& division, SceneResources& resources);

/// What the paper's method reads of the resources.
paper::RestScene restSceneOf(const SceneResources& resources);

/// Whether light is summed well enough at an object's vertices (Gong et al. 2008): edges are no
/// longer than a mean free path, and no large part of the surface has far longer ones.
bool wantsVertices(const SceneResources& resources, std::size_t object);

/// Logs the objects of which sums at vertices, if they are requested, show next to nothing.
void noteSite(const Scene& scene, const SceneResources& resources, Site site,
              const LogCallback& log);

}  // namespace opaline
