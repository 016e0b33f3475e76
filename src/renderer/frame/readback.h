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

/// Whether a variable is read off the pixels' centres.
bool needsCentre(Aov aov);

/// Whether a variable tells of light that was scattered, or of what scatters it.
bool needsScattering(Aov aov);

/// The images that a variable is made from: what is seen, or where the map has surface, and its
/// values.
std::array<gpu::GpuImage*, 2> imagesOf(Aov aov, FrameResources& resources);

/// Brings output variables of a frame to the host: copies at the frame's end what they are made
/// from, and makes pictures of it when the frame has finished. Reused for the same variables it
/// allocates nothing.
class Readback {
 public:
  /// Makes room for these variables of the next frame, of a scene that has been moved to that
  /// origin. The last frame has finished.
  void prepare(gpu::Device& device, const std::vector<Aov>& aovs, const CameraView& camera,
               const Vec3& originMm, FrameResources& resources);

  /// Records the copies, and that of how so many solutions went.
  void record(gpu::CommandList& commands, FrameResources& resources, int solutions,
              passes::Solver& solver);

  void finishSolutions(std::vector<Solution>& solutions) const;

  /// The images in the order of the variables, and these; the frame has finished.
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
