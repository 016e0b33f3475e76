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
  std::uint32_t dispatches = 0;    ///< of the last frame
  std::uint32_t barriers = 0;      ///< of the last frame
  std::uint32_t recordings = 0;    ///< of command buffers for the last frame; 0 if it took the same
                                   ///< commands as the frame before last
  double peakMemoryMegabytes = 0;  ///< of the device's memory, by this renderer
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
  bool provisional = false;         ///< the surface was still divided for the old media: see
                                    ///< FrameOrder::patient
};

/// What one frame is to give.
struct FrameOrder {
  std::vector<Aov> aovs{Aov::Radiance};  ///< brought to the host
  bool onDevice = false;  ///< leave the radiance on the device as well, as View::picture
  bool exitance = false;  ///< leave the exitance of vertices on the device, as View::exitance
  bool patient = true;    ///< wait until the surface is divided again for changed media; otherwise
                          ///< use the old division while another thread makes the new one
  bool reuseLight = false;  ///< the same picture, sooner: if only camera, size and samples changed
                            ///< since the view's last frame, reuse its light; if only lights did
                            ///< as well, reuse what tells where everything lies, and shadow maps of
                            ///< lights that did not move; if only lights did, what pixels see
  /// Left on the device as well, as View::picture(Aov). Not those of the diffusion source map.
  std::vector<Aov> aovsOnDevice;
};

/// A matrix, one column after the other, that is multiplied with columns.
using Matrix = std::array<float, 16>;

/// A camera as programs have it that draw by themselves: any perspective, with the projection's
/// middle wherever it likes, or an orthographic projection, which shows what is behind its near
/// plane.
struct CameraMatrices {
  Matrix worldToView{};  ///< from millimetres
  /// To Vulkan's clip space: x to the right and y down of -w to w, z of 0 to w. Depth may be
  /// reversed, with or without a far plane. An orthographic picture is not mirrored: what is to the
  /// right, what is below and the line of sight are a right-handed system.
  Matrix viewToClip{};
  Vec2
      jitterPixels{};  ///< by which the picture is moved right and down, if viewToClip does not yet
};

/// A picture of a renderer's scene that is made again and again: its size, its method and where it
/// is seen from. A view owns its images, what it has prepared on the device and the light that its
/// frames have found. Dropping a view frees all of it, as soon as the device has finished.
///
/// All views of a renderer share the scene and its time, and those with the same maxSurfels and
/// maxClusters its division into surfels and clusters. The renderer must outlive its views. Not
/// thread-safe: use them on the renderer's thread.
class OPALINE_API View {
 public:
  /// Throws UsageError for options out of range.
  explicit View(Renderer& renderer, const RenderOptions& options = {});
  ~View();
  View(View&&) noexcept;
  View& operator=(View&&) noexcept;
  View(const View&) = delete;
  View& operator=(const View&) = delete;

  /// From the next frame on. The next frame makes new images for another size, new tables for
  /// another transport, pattern or roughness, and new shadow maps for another shadowSize. No other
  /// option costs anything to change. Throws UsageError for options out of range.
  void setOptions(const RenderOptions& options);
  const RenderOptions& options() const;

  /// A camera of its own from the next frame on, or again the scene's. Throws Error for one that
  /// sees nothing.
  void setCamera(const std::optional<Camera>& camera);

  /// The same by matrices. Throws UsageError for what is no projection.
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

  /// The same after others' work and before it, and with outputs of theirs; see opaline/vulkan.h.
  void submit(const FrameSubmission& submission, const FrameOrder& order = {});

  /// Makes all that the next frame needs, which submits work to the queue. record() calls it too.
  /// While no option, medium or scene changes, there is nothing to do. Throws as render() does.
  void prepare(const FrameOrder& order = {});

  /// Records one frame into a command buffer of the caller's, who submits it; see opaline/vulkan.h.
  /// After prepare() nothing is submitted here. Waits until the frame before last of this view has
  /// finished. Throws as submit() does; then reset the command buffer.
  void record(const FrameRecording& recording, const FrameOrder& order = {});

  /// Waits for the oldest frame that was submitted or recorded and returns it. Frames that bring
  /// nothing to the host need not be collected: they are forgotten when others take their place.
  /// Throws UsageError when there is none.
  void collect(Frame& frame);

  /// The radiance of the frame submitted last, if it was to leave it on the device. Throws
  /// UsageError if it was not.
  DeviceImage picture() const;

  /// The same of one of FrameOrder::aovsOnDevice. All but the radiance are as View::collect() has
  /// them, also in alpha, and live until another scene or size is set, or the view goes away.
  DeviceImage picture(Aov aov) const;

  /// Of an object, what the frame submitted or recorded last has left, if it was to leave it.
  /// Throws UsageError if it was not, or for an object that there is not.
  DeviceBuffer exitance(std::size_t object) const;

  /// How the frames of this scene were made that were collected since the last render(), and its
  /// own. Throws UsageError before the first.
  RenderReport report() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace opaline
