#include "gpu/binding.h"

#include "gpu/acceleration_structure.h"
#include "gpu/buffer.h"
#include "gpu/image.h"

namespace opaline::gpu {

namespace {

Binding bufferAs(BindingType type, Access access, Buffer& buffer) {
  Binding binding;
  binding.type = type;
  binding.access = access;
  binding.buffer = &buffer;
  return binding;
}

Binding imageAs(BindingType type, Access access, GpuImage& image, VkImageView view) {
  Binding binding;
  binding.type = type;
  binding.access = access;
  binding.image = &image;
  binding.view = view;
  return binding;
}

}  // namespace

Binding Binding::at(std::uint32_t binding) const {
  Binding bound = *this;
  bound.slot = binding;
  return bound;
}

Binding Binding::asStorage() const {
  return type == BindingType::TexelBuffer ? Read(*buffer).at(slot) : *this;
}

Uniform::Uniform(Buffer& from)
    : Binding(bufferAs(BindingType::UniformBuffer, Access::Uniform, from)) {}

Uniform::Uniform(Buffer& from, std::size_t firstByte, std::size_t count) : Uniform(from) {
  offset = firstByte;
  bytes = count;
}

Read::Read(Buffer& from)
    : Binding(bufferAs(BindingType::StorageBuffer, Access::StorageRead, from)) {}

Write::Write(Buffer& to)
    : Binding(bufferAs(BindingType::StorageBuffer, Access::StorageWrite, to)) {}

Texels::Texels(Buffer& from) : Binding(bufferAs(BindingType::TexelBuffer, Access::Sampled, from)) {}

Sampled::Sampled(GpuImage& from, const Sampler& with)
    : Binding(imageAs(BindingType::SampledImage, Access::Sampled, from, from.view())) {
  sampler = with.handle();
}

WriteImage::WriteImage(GpuImage& to, std::uint32_t level)
    : Binding(imageAs(BindingType::StorageImage, Access::StorageWrite, to, to.levelView(level))) {}

TexelsOrRays::TexelsOrRays(Buffer& from) : Binding(Texels(from)) {}

TexelsOrRays::TexelsOrRays(AccelerationStructure& through)
    : Binding(bufferAs(BindingType::AccelerationStructure, Access::RayQuery, through.storage())) {
  structure = through.handle();
}

}  // namespace opaline::gpu
