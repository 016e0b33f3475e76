#pragma once

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
struct DeviceImage;  // see opaline/vulkan.h

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
  bool patient = true;    ///< wait until the surface is divided again for changed media; otherwise
                          ///< use the old division while another thread makes the new one
  bool reuseLight = false;  ///< if only the camera changed since the view's last frame, reuse its
                            ///< light: the same picture, sooner
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

  /// Renders one frame and waits for it. Throws UsageError for a variable that the method does not
  /// have, and while frames wait to be collected; Error when no scene is set or the device fails.
  RenderResult render(const FrameOrder& order = {});

  /// How many frames of a view may be submitted and not yet collected.
  static constexpr int framesInFlight = 2;

  /// Submits one frame and returns while the device renders it. Throws as render() does, and
  /// UsageError when framesInFlight frames wait to be collected. If only camera, time, lights or
  /// positions have changed, it allocates nothing.
  void submit(const FrameOrder& order = {});

  /// Waits for the oldest submitted frame and returns it. Throws UsageError when there is none.
  void collect(Frame& frame);

  /// The radiance of the frame submitted last, if it was to leave it on the device. Throws
  /// UsageError if it was not.
  DeviceImage picture() const;

  /// How the frames of this scene were made that were collected since the last render(), and its
  /// own. Throws UsageError before the first.
  RenderReport report() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace opaline
