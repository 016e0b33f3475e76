#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "opaline/image.h"
#include "opaline/log.h"
#include "opaline/scene.h"

namespace opaline {

/// How light travels from the place where it enters to the place where it leaves.
enum class Transport {
  Dipole,        ///< Jensen et al. 2001, Eq. 4; the paper's
  BetterDipole,  ///< d'Eon 2012
  Boundary,  ///< diffusion solved on the body's surface, with fine detail from the better dipole
};

/// The sources of the sum.
enum class Sum {
  Pattern,  ///< near block and eight far samples of the diffusion source map (Gong et al. 2008),
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
  Radiance,     ///< leaving towards the camera
  Exitance,     ///< B
  Irradiance,   ///< E, the light that has entered: from lights with shadows and from all around
                ///< without, but not light that left and enters again. Of the surfel seen there;
                ///< for Sum::Pattern of the diffusion source map
  Position,     ///< mm
  Normal,       ///< unit
  Depth,        ///< distance along the viewing axis, mm, in R, G and B
  Evaluations,  ///< of the profile, for a pixel or interpolated from vertices, in R, G and B
  Object,       ///< index of the object, from 0, in R, G and B
  /// Indices from 0 through all objects: in R of the visible surfel; in G of its cluster of
  /// boundary transport, -1 without one; in B of the node of the tree that contains it,
  /// RenderOptions::treeLevel below its object's root. Not for Sum::Pattern.
  Surfels,
  DsmPosition,    ///< the diffusion source map: mm
  DsmNormal,      ///< the diffusion source map: unit
  DsmIrradiance,  ///< the diffusion source map: E
  DsmArea,        ///< the diffusion source map: area of a texel on the surface, mm², in R, G and B
};

/// Whether a variable is read from the diffusion source map.
bool showsMap(Aov aov);

/// Shape of the pattern of Gong et al. 2008, Figure 5. Lengths are in mean free paths 1/σ_t' of the
/// channel with the shortest.
struct PatternOptions {
  int nearRings = 4;          ///< the near block has (2·nearRings+1)² samples, in [0, 15]
  float nearSpacing = 2.0F;   ///< between near samples, mean free paths, in [1e-3, 100]
  float farDistance = 24.0F;  ///< of the eight far samples, mean free paths, in [1e-3, 1000]
};

/// All settings of a picture outside the scene.
struct RenderOptions {
  int width = 1024;   ///< pixels, in [1, 16384]
  int height = 1024;  ///< pixels, in [1, 16384]
  Transport transport = Transport::Boundary;
  Sum sum = Sum::Tree;
  Site site = Site::Auto;
  float tolerance = 0.01F;   ///< error of a node of Sum::Tree, relative to exitance, in [1e-4, 1]
  int maxSurfels = 262'144;  ///< largest number for Sum::Tree and Sum::All, in [1024, 4194304]
  int maxClusters = 8192;    ///< largest number for Transport::Boundary, in [64, 262144]
  static constexpr int maxBounces = 8;
  int bounces = 2;  ///< times that light leaves and enters again, Transport::Boundary, in [0, 8]
  PatternOptions pattern;
  int dsmSize = 512;        ///< edge of the diffusion source map, texels, in [64, 4096]
  int shadowSize = 1024;    ///< edge of each shadow map, texels, in [64, 8192]
  bool specular = true;     ///< GGX reflection of lights and environment on top
  float roughness = 0.25F;  ///< of that reflection, GGX α = roughness², in [0.05, 1]
  int treeLevel = 64;       ///< of the nodes in Aov::Surfels: 0 for the objects' roots, leaves if
                            ///< these come first; in [0, 64]
  int antialias = 4;        ///< samples per pixel of Aov::Radiance: 1, 2, 4 or 8
  int frames = 1;           ///< how often render() repeats the picture, for timing; in [1, 1000000]
  double seconds = 0;       ///< time of clip and deformers, s, in [0, 1e6]
  int clip = 0;             ///< index of the clip that plays; -1: none, nodes as in the file
  bool patient = true;  ///< wait until the surface is divided again for changed media; otherwise
                        ///< use the old division while another thread makes the new one
  bool reuseLight = false;  ///< if only the camera changed since a frame of this size and method,
                            ///< reuse its light: the same picture, sooner
};

/// GPU time of one pass.
struct PassTime {
  std::string name;
  double milliseconds = 0;  ///< median over the frames after the first
};

/// The device a renderer runs on.
struct DeviceDescription {
  std::string name;
  std::string type;  ///< discrete, integrated, virtual or software
  std::string driver;
  bool rayQueries = false;  ///< has VK_KHR_ray_query
};

/// How the boundary's equation was solved, for direct light or for a bounce.
struct Solution {
  int steps = 0;   ///< of generalised minimal residuals
  Rgb residual{};  ///< relative to the sources of fluence
};

/// What a call of render() did.
struct RenderReport {
  DeviceDescription device;
  Transport transport = Transport::Dipole;  ///< BetterDipole if Boundary was requested and nothing
                                            ///< has an inside
  Sum sum = Sum::Tree;
  Site site = Site::Fragment;  ///< Auto where it differs between objects
  std::size_t triangles = 0;
  std::size_t vertices = 0;
  std::size_t sources = 0;   ///< surfels, or texels of the map that contain surface
  std::size_t clusters = 0;  ///< unknowns of Transport::Boundary
  /// Of Transport::Boundary in the last frame: one for direct light, then one for each bounce.
  std::vector<Solution> solutions;
  std::vector<PassTime> passes;    ///< in the order they ran
  double frameMilliseconds = 0;    ///< GPU time, median over the frames after the first
  double peakMemoryMegabytes = 0;  ///< of the device's memory, by this renderer
};

/// Pictures, in the requested order, and a report.
struct RenderResult {
  std::vector<Image> images;
  RenderReport report;
};

/// One finished frame. Renderer::collect fills the same object again and again without allocating.
struct Frame {
  std::vector<Image> images;  ///< in the requested order
  double milliseconds = 0;    ///< GPU time
  std::vector<PassTime> passes;
  std::vector<Solution> solutions;  ///< as in RenderReport
  bool provisional = false;         ///< the surface was still divided for the old media: see
                                    ///< RenderOptions::patient
};

// For callers who work with the renderer's Vulkan device; see opaline/vulkan.h.
struct DeviceImage;
struct DevicePositions;
struct VulkanDevice;

class SoftBody;
namespace gpu {
class Device;
}

/// Which device to use.
struct RendererOptions {
  std::string device;       ///< index or part of a name; empty: the best there is
  bool validation = false;  ///< run Vulkan's validation layer; its messages go to the log
  LogCallback log;
  /// Vulkan extensions that the caller needs in addition, for example those of windows.
  std::vector<std::string> instanceExtensions;
  std::vector<std::string> deviceExtensions;
  /// Rays by VK_KHR_ray_query instead of compute shaders; pictures differ by rounding. Empty: used
  /// on every device with ray queries, except software devices.
  std::optional<bool> rayQueries;
};

/// All Vulkan devices of this machine, in the order of their index; empty when there is none.
std::vector<DeviceDescription> listDevices();

/// Renders one scene at a time, any number of pictures of it. Not thread-safe.
class Renderer {
 public:
  explicit Renderer(const RendererOptions& options = {});
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Uploads the scene. Throws Error when the device has too little memory.
  void setScene(const Scene& scene);

  /// Renders the scene and returns one image for each of `aovs`. Throws UsageError for options out
  /// of range and Error when no scene is set or the device fails.
  RenderResult render(const RenderOptions& options, const std::vector<Aov>& aovs = {Aov::Radiance});

  /// How many frames may be submitted and not yet collected.
  static constexpr int framesInFlight = 2;

  /// Submits one frame and returns while the device renders it. Throws as render() does, and
  /// UsageError when framesInFlight frames wait to be collected. If only seconds and clip changed
  /// in the scene and options, it allocates nothing.
  void submit(const RenderOptions& options, const std::vector<Aov>& aovs = {Aov::Radiance});

  /// submit() for callers who show the picture: its radiance stays on the device. Work submitted
  /// after this call may sample it. collect() returns `aovs`.
  DeviceImage submitOnDevice(const RenderOptions& options, const std::vector<Aov>& aovs = {});

  /// Waits for the oldest submitted frame and returns it. Throws UsageError when there is none.
  void collect(Frame& frame);

  /// The report of the frames collected since the last setScene().
  RenderReport report() const;

  /// Edits of the scene, from the next submitted frame on. They remake only what depends on the
  /// change: nothing for a camera, for deformers, and for a light that moves or changes its power;
  /// tables for ambient light; the division into surfels for a medium; and never the mesh or its
  /// atlas. An environment counts as changed if it is another object. They throw Error or
  /// UsageError as setScene() does.
  void setCamera(const Camera& camera);
  void setLighting(const Lighting& lighting);
  void setMedium(std::size_t object, const Medium& medium);
  void setDeformers(const std::vector<Deformer>& deformers);

  /// Sets the positions of the object's vertices from the next submitted frame on, instead of its
  /// mesh or rig. Normals follow, and the scene's deformers still apply. The values are copied.
  /// Throws UsageError unless there is a position for each vertex, finite and within 1e18 mm.
  void replacePositions(std::size_t object, std::span<const Vec3> positionsMm);

  /// The same from a buffer of the device, which every frame reads again.
  void replacePositions(std::size_t object, const DevicePositions& positions);

  /// Undoes replacePositions.
  void restorePositions(std::size_t object);

  /// The Vulkan objects of this renderer.
  VulkanDevice vulkanDevice() const;

  /// Messages of the validation layer so far; 0 without validation.
  std::size_t validationMessages() const;

 private:
  friend class SoftBody;
  gpu::Device& device();
  std::uint64_t sceneNumber() const;  // how often one was set
  std::size_t vertexCount(std::size_t object) const;

  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace opaline
