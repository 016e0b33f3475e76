#include "gpu/acceleration_structure.h"
#include "gpu/command_list.h"

namespace opaline::gpu {

Binding Binding::uniform(std::uint32_t slot, Buffer& buffer, std::size_t offset,
                         std::size_t bytes) {
  Binding binding;
  binding.slot = slot;
  binding.type = BindingType::UniformBuffer;
  binding.access = Access::Uniform;
  binding.buffer = &buffer;
  binding.offset = offset;
  binding.bytes = bytes;
  return binding;
}

Binding Binding::read(std::uint32_t slot, Buffer& buffer) {
  Binding binding;
  binding.slot = slot;
  binding.access = Access::StorageRead;
  binding.buffer = &buffer;
  return binding;
}

Binding Binding::write(std::uint32_t slot, Buffer& buffer) {
  Binding binding = read(slot, buffer);
  binding.access = Access::StorageWrite;
  return binding;
}

Binding Binding::texels(std::uint32_t slot, Buffer& buffer) {
  Binding binding;
  binding.slot = slot;
  binding.type = BindingType::TexelBuffer;
  binding.access = Access::Sampled;
  binding.buffer = &buffer;
  return binding;
}

Binding Binding::sampled(std::uint32_t slot, GpuImage& image, const Sampler& sampler) {
  Binding binding;
  binding.slot = slot;
  binding.type = BindingType::SampledImage;
  binding.access = Access::Sampled;
  binding.image = &image;
  binding.view = image.view();
  binding.sampler = sampler.handle();
  return binding;
}

Binding Binding::writeImage(std::uint32_t slot, GpuImage& image) {
  return writeImageLevel(slot, image, 0);
}

Binding Binding::writeImageLevel(std::uint32_t slot, GpuImage& image, std::uint32_t level) {
  Binding binding;
  binding.slot = slot;
  binding.type = BindingType::StorageImage;
  binding.access = Access::StorageWrite;
  binding.image = &image;
  binding.view = image.levelView(level);
  return binding;
}

Binding Binding::rays(std::uint32_t slot, AccelerationStructure& structure) {
  Binding binding;
  binding.slot = slot;
  binding.type = BindingType::AccelerationStructure;
  binding.access = Access::RayQuery;
  binding.buffer = &structure.storage();
  binding.structure = structure.handle();
  return binding;
}

}  // namespace opaline::gpu
