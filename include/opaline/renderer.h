#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "opaline/export.h"
#include "opaline/log.h"
#include "opaline/motion.h"
#include "opaline/render_options.h"
#include "opaline/scene.h"
#include "opaline/view.h"

namespace opaline {

// For callers who use the renderer's Vulkan device or pass one of their own; see opaline/vulkan.h.
struct DevicePositions;
struct GivenVulkan;
struct VulkanDevice;

class RendererContext;

/// A device of the caller's, or none. Holds a copy of the GivenVulkan.
class OPALINE_API Given {
 public:
  Given() = default;
  Given(const GivenVulkan& given);  // NOLINT: so that `options.given = mine` does
  Given(const GivenVulkan* given);  // NOLINT: null: none
  /// Null without a device.
  const GivenVulkan* get() const { return given_.get(); }

 private:
  std::shared_ptr<const GivenVulkan> given_;
};

/// Which device to use.
struct RendererOptions {
  std::string device;       ///< index or part of a name; empty: the best there is
  bool validation = false;  ///< run Vulkan's validation layer; its messages go to the log
  LogCallback log;
  /// Vulkan extensions that the caller needs in addition, for example those of windows.
  std::vector<std::string> instanceExtensions;
  std::vector<std::string> deviceExtensions;
  /// Whether to trace rays by VK_KHR_ray_query instead of by compute shaders; pictures differ by
  /// rounding. Empty: on every device that has ray queries, except software devices.
  std::optional<bool> rayQueries;
  /// MB (10⁶ bytes) of the device's memory, in [64, 1e7]; none: what the device has.
  std::optional<float> memoryLimit;
  /// A device of the caller's instead of one that the renderer opens; see opaline/vulkan.h. With
  /// it, `device`, `validation` and the extensions have to stay empty.
  Given given;
  /// What Renderer::pipelineCache returned in an earlier run; spares the driver most compilations.
  /// Other data, and caches of other devices or drivers, have no effect.
  std::vector<std::byte> pipelineCache;
};

/// All Vulkan devices of this machine, in the order of their index; empty when there is none.
OPALINE_API std::vector<DeviceDescription> listDevices();

/// Holds one scene at a time. Any number of views make pictures of it. Not thread-safe.
class OPALINE_API Renderer {
 public:
  explicit Renderer(const RendererOptions& options = {});
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Sets the scene at time 0 of its first clip. Throws Error for a scene that cannot be rendered,
  /// and when the device has too little memory.
  void setScene(const Scene& scene);

  /// One picture, by a view that the renderer keeps for such calls. Returns an image for each of
  /// `aovs`. Throws as View::render does, and UsageError for options out of range.
  RenderResult render(const RenderOptions& options, const std::vector<Aov>& aovs = {Aov::Radiance});

  /// Edits of the scene, from the next submitted frame on. Each remakes only what depends on it:
  /// nothing for a time, a camera, deformers, or a light that moves or changes its power; tables
  /// for ambient light; the division into surfels for a medium; and never the mesh. An environment
  /// counts as changed if it is another object. Lights and materials that differ from those of the
  /// scene as it was set do not follow its clips, nor does a camera once it was given another
  /// place. These calls throw Error or UsageError as setScene() does.
  void setTime(const SceneTime& time);
  void setCamera(const Camera& camera);
  void setLighting(const Lighting& lighting);
  /// The suns of the scene's environment, brightest first. They are taken out of the picture and
  /// shine as lights besides the scene's own.
  const std::vector<DirectionalLight>& suns() const;
  void setMedium(std::size_t object, const Medium& medium);
  /// An opaque object has to stay opaque and a translucent one translucent, or UsageError is
  /// thrown. New numbers remake tables; new textures are packed again.
  void setMaterial(std::size_t object, const Material& material);
  void setDeformers(const std::vector<Deformer>& deformers);

  /// Sets the positions of the object's vertices from the next submitted frame on, instead of its
  /// mesh or rig. Normals follow, and the scene's deformers still apply. The values are copied.
  /// Throws UsageError unless there is a position for each vertex, finite and within 1e9 mm of the
  /// middle of the scene.
  void replacePositions(std::size_t object, std::span<const Vec3> positionsMm);

  /// The same from a buffer of the device, which every frame reads again.
  void replacePositions(std::size_t object, const DevicePositions& positions);

  /// Undoes replacePositions.
  void restorePositions(std::size_t object);

  /// The Vulkan objects of this renderer.
  VulkanDevice vulkanDevice() const;

  /// The pipelines that were compiled so far, for RendererOptions::pipelineCache of a later run.
  /// Throws Error when there is no memory for them.
  std::vector<std::byte> pipelineCache() const;

  /// Bytes of the device's memory that this renderer and its views occupy now.
  std::size_t memoryBytes() const;

  /// Messages of the validation layer so far; 0 without validation.
  std::size_t validationMessages() const;

  /// For the library's own classes.
  RendererContext& context() const { return *context_; }

 private:
  std::unique_ptr<RendererContext> context_;
};

}  // namespace opaline
