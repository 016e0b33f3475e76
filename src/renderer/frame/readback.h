#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/command_list.h"
#include "opaline/renderer.h"
#include "renderer/frame/camera_view.h"
#include "renderer/frame/frame.h"

namespace opaline {

/// Whether a variable is read from the pixels' centres.
bool needsCentre(Aov aov);

/// Whether a variable depends on scattered light, or on what scatters it.
bool needsScattering(Aov aov);

/// The two images that a variable is made from: one for coverage, of pixels or of the map, and one
/// for values.
std::array<gpu::GpuImage*, 2> imagesOf(Aov aov, FrameResources& resources);

/// Brings output variables of a frame to the host: it copies their sources at the frame's end, and
/// makes pictures of them when the frame has finished. When it is reused for the same variables, it
/// allocates nothing.
class Readback {
 public:
  /// Makes room for these variables of the next frame. The scene has been moved to that origin, and
  /// the last frame has finished.
  void prepare(gpu::Device& device, const std::vector<Aov>& aovs, const CameraView& camera,
               const Vec3& originMm, FrameResources& resources);

  /// Records the copies of images, and of the states of that many solutions.
  void record(gpu::CommandList& commands, FrameResources& resources, int solutions,
              passes::Solver& solver);

  void finishSolutions(std::vector<Solution>& solutions) const;

  /// Returns the images in the order of the variables, and the variables. The frame has finished.
  void finish(std::vector<Image>& images, std::vector<Aov>& aovs) const;

 private:
  void recordImages(gpu::CommandList& commands, FrameResources& resources);
  void recordSolutions(gpu::CommandList& commands, int count, passes::Solver& solver);

  /// What one image left in the buffer.
  struct Source {
    std::size_t offset = 0;
    VkExtent2D extent{};
  };
  struct Entry {
    Aov aov = Aov::Radiance;
    std::array<Source, 2> sources;
  };

  void make(const Entry& entry, Image& image) const;
  template <typename T>
  const T* texels(const Source& source) const;

  gpu::Buffer buffer_;
  gpu::Buffer states_;  // shared::SolverState
  int solutions_ = 0;
  std::vector<Entry> entries_;
  CameraView camera_;
  glm::vec3 origin_{0};
};

}  // namespace opaline
