#pragma once

#include "opaline/export.h"

namespace opaline {

/// How light travels from the place where it enters to the place where it leaves.
enum class Transport {
  Dipole,        ///< Jensen et al. 2001, Eq. 4; the paper's
  BetterDipole,  ///< d'Eon 2012
  Boundary,  ///< diffusion solved on the body's surface, with fine detail from the better dipole
};

/// The sources of the sum.
enum class Sum {
  Pattern,  ///< a near block and eight far samples of the diffusion source map (Gong et al. 2008);
            ///< not for Transport::Boundary
  Tree,     ///< surfels in object space, in groups where the tolerance allows
  All,      ///< every surfel, one by one
};

/// Where the sum is evaluated.
enum class Site {
  Auto,      ///< chosen for each object: Vertex if its edges are at most one mean free path long,
             ///< else Fragment; Sum::Pattern uses Fragment for all if one object needs it
  Vertex,    ///< once per vertex, interpolated (the paper's VTF)
  Fragment,  ///< once per visible pixel (the paper's FTF)
};

/// The output variables. All but Radiance are sampled once, at the pixel's centre.
enum class Aov {
  Radiance,    ///< leaving towards the camera
  Exitance,    ///< B
  Irradiance,  ///< E of the surfel seen there, or of the diffusion source map for Sum::Pattern:
               ///< light that has entered, from lights with shadows and from the sky, which
               ///< surfaces hide as for ambientOcclusion. Light that left and enters again does not
               ///< count
  Position,    ///< mm
  Normal,      ///< unit, within 0.0005
  Depth,       ///< distance along the viewing axis, mm, in R, G and B
  Evaluations,  ///< of the profile, per pixel or interpolated from vertices, in R, G and B
  Object,       ///< index of the object, from 0, in R, G and B
  /// Indices, counted from 0 through all objects. R: the visible surfel. G: its cluster of boundary
  /// transport, -1 without one. B: the node of the tree that contains it, RenderOptions::treeLevel
  /// levels below its object's root. Not for Sum::Pattern.
  Surfels,
  DsmPosition,    ///< the diffusion source map: mm
  DsmNormal,      ///< the diffusion source map: unit, within 0.0005
  DsmIrradiance,  ///< the diffusion source map: E
  DsmArea,        ///< the diffusion source map: area of a texel on the surface, mm², in R, G and B
};

/// Whether a variable is read from the diffusion source map.
OPALINE_API bool showsMap(Aov aov);

/// Shape of the pattern of Gong et al. 2008, Figure 5. Lengths are in mean free paths 1/σ_t' of the
/// channel where that is shortest.
struct PatternOptions {
  int nearRings = 4;          ///< the near block has (2·nearRings+1)² samples, in [0, 15]
  float nearSpacing = 2.0F;   ///< between near samples, mean free paths, in [1e-3, 100]
  float farDistance = 24.0F;  ///< of the eight far samples, mean free paths, in [1e-3, 1000]
};

/// What describes a picture besides the scene.
struct RenderOptions {
  int width = 1024;   ///< pixels, in [1, 16384]
  int height = 1024;  ///< pixels, in [1, 16384]
  Transport transport = Transport::Boundary;
  Sum sum = Sum::Tree;
  Site site = Site::Auto;
  float tolerance = 0.01F;   ///< error of a node of Sum::Tree, relative to exitance, in [1e-4, 1]
  int maxSurfels = 262'144;  ///< largest number for Sum::Tree and Sum::All, in [1024, 4194304]
  int maxClusters = 8192;    ///< for boundary transport or hidden sky, in [64, 262144]
  static constexpr int maxBounces = 8;
  int bounces = 2;  ///< times that light leaves and enters again in Transport::Boundary, in [0, 8]
  bool ambientOcclusion = false;  ///< whether surfaces hide ambient light and environment; with
                                  ///< Transport::Boundary they always do
  PatternOptions pattern;
  int dsmSize = 512;        ///< edge of the diffusion source map, texels, in [64, 4096]
  int shadowSize = 1024;    ///< edge of each shadow map, texels, in [64, 8192]
  bool specular = true;     ///< add the GGX reflection of lights and environment
  float roughness = 0.25F;  ///< of that reflection, GGX α = roughness², in [0.05, 1]
  int treeLevel = 64;       ///< level of the nodes in Aov::Surfels, in [0, 64]: 0 for the objects'
                            ///< roots; leaves above that level count too
  int antialias = 4;        ///< samples per pixel of Aov::Radiance: 1, 2, 4 or 8
  /// Whether environment and ambient light fill the pixels of Aov::Radiance that no surface covers.
  bool environmentBehind = false;
};

}  // namespace opaline
