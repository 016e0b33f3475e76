#include "renderer/frame/readback.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "gpu/device.h"
#include "shaders/shared/boundary.h"

namespace opaline {

namespace {

using Halves = std::array<std::uint16_t, 4>;

std::size_t bytesOf(const gpu::GpuImage& image) {
  constexpr std::size_t alignment = 16;
  const std::size_t bytes = std::size_t{image.extent().width} * image.extent().height *
                            gpu::bytesPerTexel(image.options().format);
  return (bytes + alignment - 1) / alignment * alignment;
}

void resize(Image& image, VkExtent2D extent) {
  image.width = static_cast<int>(extent.width);
  image.height = static_cast<int>(extent.height);
  image.rgba.resize(std::size_t{4} * extent.width * extent.height);
}

// Sets the colour of every pixel to `colour` of its index, and its alpha by `covered`.
template <typename Colour, typename Covered>
void fill(Image& image, const Covered& covered, const Colour& colour) {
  for (std::size_t i = 0; i < image.rgba.size() / 4; ++i) {
    const bool hit = covered(i);
    const glm::vec3 value = hit ? colour(i) : glm::vec3(0);
    float* pixel = &image.rgba[4 * i];
    pixel[0] = value.x;
    pixel[1] = value.y;
    pixel[2] = value.z;
    pixel[3] = hit ? 1.0F : 0.0F;
  }
}

glm::vec3 unpack(const Halves& half) {
  return {glm::unpackHalf1x16(half[0]), glm::unpackHalf1x16(half[1]), glm::unpackHalf1x16(half[2])};
}

// The accumulated samples hold colour times coverage.
void makeRadiance(Image& image, const glm::vec4* sums) {
  for (std::size_t i = 0; i < image.rgba.size() / 4; ++i) {
    const float coverage = sums[i].a;
    const glm::vec3 colour = coverage > 0 ? glm::vec3(sums[i]) / coverage : glm::vec3(sums[i]);
    float* pixel = &image.rgba[4 * i];
    pixel[0] = colour.x;
    pixel[1] = colour.y;
    pixel[2] = colour.z;
    pixel[3] = coverage > 0 ? std::min(coverage, 1.0F) : coverage;
  }
}

}  // namespace

std::array<gpu::GpuImage*, 2> imagesOf(Aov aov, FrameResources& resources) {
  gpu::GpuImage* const position = &resources.centres.position;
  switch (aov) {
    case Aov::Radiance:
      return {&resources.radiance, nullptr};
    case Aov::Exitance:
    case Aov::Evaluations:
      return {position, &resources.centres.exitance};
    case Aov::Irradiance:
      return {position, &resources.seenIrradiance};
    case Aov::Position:
    case Aov::Depth:
    case Aov::Object:
      return {position};
    case Aov::Normal:
      return {position, &resources.centres.normal};
    case Aov::Surfels:
      return {position, &resources.seenSurfels.image};
    case Aov::DsmPosition:
    case Aov::DsmArea:
      return {&resources.map->sources.coverage, &resources.map->sources.positionArea};
    case Aov::DsmNormal:
      return {&resources.map->sources.coverage, &resources.map->sources.normal};
    case Aov::DsmIrradiance:
      return {&resources.map->sources.coverage, &resources.map->sources.irradianceObject};
  }
  return {};
}

bool showsMap(Aov aov) {
  return aov == Aov::DsmPosition || aov == Aov::DsmNormal || aov == Aov::DsmIrradiance ||
         aov == Aov::DsmArea;
}

bool needsCentre(Aov aov) {
  switch (aov) {
    case Aov::Exitance:
    case Aov::Evaluations:
    case Aov::Irradiance:
    case Aov::Position:
    case Aov::Normal:
    case Aov::Depth:
    case Aov::Object:
    case Aov::Surfels:
      return true;
    default:
      return false;
  }
}

bool needsScattering(Aov aov) {
  switch (aov) {
    case Aov::Radiance:
    case Aov::Exitance:
    case Aov::Evaluations:
    case Aov::Surfels:
      return true;
    default:
      return false;
  }
}

void Readback::prepare(gpu::Device& device, const std::vector<Aov>& aovs, const CameraView& camera,
                       const Vec3& originMm, FrameResources& resources) {
  if (!states_)
    states_ =
        gpu::Buffer(device, {.name = "solutions on the host",
                             .bytes = (RenderOptions::maxBounces + 1) * sizeof(shared::SolverState),
                             .memory = gpu::Memory::Readback});
  camera_ = camera;
  origin_ = {originMm[0], originMm[1], originMm[2]};
  entries_.clear();
  std::size_t bytes = 0;
  for (const Aov aov : aovs) {
    Entry entry{.aov = aov};
    const std::array<gpu::GpuImage*, 2> images = imagesOf(aov, resources);
    for (std::size_t i = 0; i < images.size(); ++i) {
      if (images[i] == nullptr) continue;
      entry.sources[i] = {bytes, images[i]->extent()};
      bytes += bytesOf(*images[i]);
    }
    entries_.push_back(entry);
  }
  if (bytes == 0 || (buffer_ && buffer_.bytes() >= bytes)) return;
  buffer_ = {};
  buffer_ =
      gpu::Buffer(device, {.name = "readback", .bytes = bytes, .memory = gpu::Memory::Readback});
}

void Readback::record(gpu::CommandList& commands, FrameResources& resources, int solutions,
                      passes::Solver& solver) {
  // There is one barrier for everything that is copied, and one for the host.
  if (solutions > 0) commands.use(solver.states, gpu::Access::TransferRead);
  recordImages(commands, resources);
  recordSolutions(commands, solutions, solver);
  if (!entries_.empty()) commands.use(buffer_, gpu::Access::HostRead);
  if (solutions > 0) commands.use(states_, gpu::Access::HostRead);
}

void Readback::recordImages(gpu::CommandList& commands, FrameResources& resources) {
  for (const Entry& entry : entries_) {
    const std::array<gpu::GpuImage*, 2> images = imagesOf(entry.aov, resources);
    for (std::size_t i = 0; i < images.size(); ++i)
      if (images[i] != nullptr)
        commands.copyFromImage(*images[i], buffer_, 0, 0, entry.sources[i].offset);
  }
}

template <typename T>
const T* Readback::texels(const Source& source) const {
  return reinterpret_cast<const T*>(buffer_.mapped().data() + source.offset);
}

void Readback::make(const Entry& entry, Image& image) const {
  const Source& first = entry.sources[0];
  const Source& second = entry.sources[1];
  resize(image, first.extent);
  const auto* visible = texels<glm::vec4>(first);
  const auto seen = [&](std::size_t i) { return visible[i].w > 0; };
  const auto* objects = texels<std::uint32_t>(first);
  const auto onMap = [&](std::size_t i) { return objects[i] != 0; };
  const auto floats = [values = texels<glm::vec4>(second)](std::size_t i) {
    return glm::vec3(values[i]);
  };
  const auto halves = [values = texels<Halves>(second)](std::size_t i) {
    return unpack(values[i]);
  };
  switch (entry.aov) {
    case Aov::Radiance:
      return makeRadiance(image, visible);
    case Aov::Exitance:
    case Aov::Irradiance:
    case Aov::Surfels:
      return fill(image, seen, floats);
    case Aov::Evaluations:
      return fill(image, seen,
                  [&](std::size_t i) { return glm::vec3(texels<glm::vec4>(second)[i].w); });
    case Aov::Position:
      return fill(image, seen, [&](std::size_t i) { return glm::vec3(visible[i]) + origin_; });
    case Aov::Depth:
      return fill(image, seen, [&](std::size_t i) {
        return glm::vec3(glm::dot(glm::vec3(visible[i]) - camera_.position, camera_.axis));
      });
    case Aov::Object:
      return fill(image, seen, [&](std::size_t i) { return glm::vec3(visible[i].w - 1); });
    case Aov::Normal:
      return fill(image, seen, halves);
    case Aov::DsmPosition:
      return fill(image, onMap, [&](std::size_t i) { return floats(i) + origin_; });
    case Aov::DsmIrradiance:
      return fill(image, onMap, floats);
    case Aov::DsmNormal:
      return fill(image, onMap, halves);
    case Aov::DsmArea:
      return fill(image, onMap,
                  [&](std::size_t i) { return glm::vec3(texels<glm::vec4>(second)[i].w); });
  }
}

void Readback::finish(std::vector<Image>& images, std::vector<Aov>& aovs) const {
  images.resize(entries_.size());
  aovs.resize(entries_.size());
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    make(entries_[i], images[i]);
    aovs[i] = entries_[i].aov;
  }
}

void Readback::recordSolutions(gpu::CommandList& commands, int count, passes::Solver& solver) {
  solutions_ = count;
  if (count == 0) return;
  commands.copyBuffer(solver.states, states_,
                      static_cast<std::size_t>(count) * sizeof(shared::SolverState));
}

void Readback::finishSolutions(std::vector<Solution>& solutions) const {
  solutions.resize(static_cast<std::size_t>(solutions_));
  for (std::size_t i = 0; i < solutions.size(); ++i) {
    const shared::SolverState& state = states_.mappedAs<shared::SolverState>()[i];
    solutions[i] = {static_cast<int>(state.steps),
                    {state.residual.x, state.residual.y, state.residual.z}};
  }
}

}  // namespace opaline
