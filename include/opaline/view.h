#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "opaline/export.h"
#include "opaline/image.h"
#include "opaline/render_options.h"
#include "opaline/scene.h"

namespace opaline {

class Renderer;
// See opaline/vulkan.h.
struct DeviceBuffer;
struct DeviceImage;
struct FrameRecording;
struct FrameSubmission;

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

/// How the frames of a view were made.
struct RenderReport {
  DeviceDescription device;
  Transport transport = Transport::Dipole;  ///< BetterDipole if Boundary was requested but no
                                            ///< object has an inside
  Sum sum = Sum::Tree;
  Site site = Site::Fragment;  ///< Auto where it differs between objects
  std::size_t triangles = 0;
  std::size_t vertices = 0;
  std::size_t sources = 0;   ///< surfels, or texels of the map that contain surface
  std::size_t clusters = 0;  ///< unknowns of Transport::Boundary
  /// Of Transport::Boundary in the last frame: one for direct light, then one for each bounce.
  std::vector<Solution> solutions;
  std::vector<PassTime> passes;  ///< in the order they ran
  double frameMilliseconds = 0;  ///< GPU time, median over the frames after the first
  std::uint32_t dispatches = 0;  ///< of the last frame
  std::uint32_t barriers = 0;    ///< of the last frame
  std::uint32_t recordings = 0;  ///< of command buffers for the last frame; 0 if it reused those of
                                 ///< the frame before last
  double peakMemoryMegabytes = 0;  ///< highest use of the device's memory by this renderer
};

/// Pictures, in the requested order, and a report.
struct RenderResult {
  std::vector<Image> images;
  RenderReport report;
};

/// One finished frame. View::collect fills the same object again and again without allocating.
struct Frame {
  std::vector<Image> images;  ///< in the requested order
  std::vector<Aov> aovs;      ///< what they show
  double milliseconds = 0;    ///< GPU time
  std::vector<PassTime> passes;
  std::vector<Solution> solutions;  ///< as in RenderReport
  bool provisional = false;  ///< it used the surfels of the old media; see FrameOrder::patient
};

/// What one frame is to deliver.
struct FrameOrder {
  std::vector<Aov> aovs{Aov::Radiance};  ///< copied to the host
  bool onDevice = false;  ///< also leave the radiance on the device, for View::picture
  bool exitance = false;  ///< leave the exitance of vertices on the device, for View::exitance
  bool patient = true;  ///< after a change of media, wait until the surface is divided into surfels
                        ///< again; otherwise use the old surfels while another thread makes new
                        ///< ones
  /// Makes the same picture sooner. If only camera, size and samples changed since the view's last
  /// frame, it reuses that frame's light. If lights changed too, it reuses geometry and the shadow
  /// maps of lights that did not move; if only lights changed, also what each pixel sees.
  bool reuseLight = false;
  /// Also left on the device, for View::picture(Aov). Excludes those of the diffusion source map.
  std::vector<Aov> aovsOnDevice;
};

/// A matrix in column-major order, which multiplies column vectors.
using Matrix = std::array<float, 16>;

/// The camera of a program that also draws by itself: any perspective projection, off-centre ones
/// included, or an orthographic projection, of which only what lies beyond the near plane is shown.
struct CameraMatrices {
  Matrix worldToView{};  ///< from millimetres
  /// To Vulkan's clip space: x to the right and y down of -w to w, z of 0 to w. Depth may be
  /// reversed, with or without a far plane. An orthographic picture is not mirrored: what is to the
  /// right, what is below and the line of sight are a right-handed system.
  Matrix viewToClip{};
  Vec2 jitterPixels{};  ///< shift of the picture to the right and down, unless viewToClip contains
                        ///< it
};

/// A way to picture a renderer's scene, frame after frame: a size, a method and a camera. A view
/// owns its images, what it prepared on the device and the light of its frames. Destroying a view
/// frees all of that as soon as the device has finished.
///
/// All views of a renderer share the scene and its time. Those with the same maxSurfels and
/// maxClusters also share its division into surfels and clusters. The renderer must outlive its
/// views. Not thread-safe: use them on the renderer's thread.
class OPALINE_API View {
 public:
  /// Throws UsageError for options out of range.
  explicit View(Renderer& renderer, const RenderOptions& options = {});
  ~View();
  View(View&&) noexcept;
  View& operator=(View&&) noexcept;
  View(const View&) = delete;
  View& operator=(const View&) = delete;

  /// Takes effect with the next frame. That frame makes new images for another size, new tables for
  /// another transport, pattern or roughness, and new shadow maps for another shadowSize. Other
  /// options cost nothing to change. Throws UsageError for options out of range.
  void setOptions(const RenderOptions& options);
  const RenderOptions& options() const;

  /// Gives the view a camera of its own from the next frame on; without a value, the scene's again.
  /// Throws Error for a camera that sees nothing.
  void setCamera(const std::optional<Camera>& camera);

  /// The same by matrices. Throws UsageError for a matrix that is not a projection.
  void setCamera(const CameraMatrices& matrices);

  /// Renders one frame and waits for it. Throws UsageError for a variable that the method does not
  /// have, and while frames wait to be collected; Error when no scene is set or the device fails.
  RenderResult render(const FrameOrder& order = {});

  /// How many frames of a view may be submitted and not yet collected.
  static constexpr int framesInFlight = 2;

  /// Submits one frame and returns while the device renders it. Throws as render() does, and
  /// UsageError when framesInFlight frames with pictures for the host wait to be collected. If only
  /// camera, time, lights or positions have changed, it allocates nothing.
  void submit(const FrameOrder& order = {});

  /// The same, ordered among the caller's own work and with outputs in its memory; see
  /// opaline/vulkan.h.
  void submit(const FrameSubmission& submission, const FrameOrder& order = {});

  /// Makes all that the next frame needs, which submits work to the queue. record() calls it too.
  /// Unless an option, a medium or the scene has changed, it does nothing. Throws as render() does.
  void prepare(const FrameOrder& order = {});

  /// Records one frame into a command buffer that the caller submits; see opaline/vulkan.h. After
  /// prepare() it submits nothing itself. Waits until the frame before last of this view has
  /// finished. Throws as submit() does; the command buffer then has to be reset.
  void record(const FrameRecording& recording, const FrameOrder& order = {});

  /// Waits for the oldest frame that was submitted or recorded and returns it. Frames without
  /// pictures for the host need not be collected: later frames take their place. Throws UsageError
  /// when there is none.
  void collect(Frame& frame);

  /// The radiance that the last submitted frame left on the device. Throws UsageError if its order
  /// did not ask for that.
  DeviceImage picture() const;

  /// The same for one of FrameOrder::aovsOnDevice. All but the radiance have the values, alpha
  /// included, that View::collect() returns. They live until another scene or size is set or the
  /// view is destroyed.
  DeviceImage picture(Aov aov) const;

  /// The exitance of an object's vertices that the last submitted or recorded frame left on the
  /// device. Throws UsageError if its order did not ask for that, or if there is no such object.
  DeviceBuffer exitance(std::size_t object) const;

  /// How the last render() and the frames of this scene collected since then were made. Throws
  /// UsageError before the first frame.
  RenderReport report() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace opaline
