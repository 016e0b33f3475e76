#pragma once

#include <vulkan/vulkan.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "gpu/access.h"
#include "gpu/shader.h"

namespace opaline::gpu {

class AccelerationStructure;
class Buffer;
class GpuImage;
class Sampler;

/// A resource at a binding of the bound pipeline. Binding it is also what orders it: the command
/// list records the barrier from its last access to the one named here.
struct Binding {
  std::uint32_t slot = 0;
  BindingType type = BindingType::StorageBuffer;
  Access access = Access::None;
  Buffer* buffer = nullptr;
  std::size_t offset = 0;
  std::size_t bytes = 0;
  GpuImage* image = nullptr;
  VkImageView view = VK_NULL_HANDLE;
  VkSampler sampler = VK_NULL_HANDLE;
  VkAccelerationStructureKHR structure = VK_NULL_HANDLE;

  Binding at(std::uint32_t binding) const;
  /// The binding of texels for a shader's variant that reads storage (ShaderVariant).
  Binding asStorage() const;
};

// What a shader's Bindings are made of. A resource stands for each by itself.
// NOLINTBEGIN(google-explicit-constructor)

struct Uniform : Binding {
  Uniform(Buffer& from);
  Uniform(Buffer& from, std::size_t firstByte, std::size_t count);
};

struct Read : Binding {
  Read(Buffer& from);
};

struct Write : Binding {
  Write(Buffer& to);
};

/// The buffer also holds the size of the dispatch.
struct WriteIndirect : Write {
  WriteIndirect(Buffer& to) : Write(to) { access = Access::StorageWriteIndirect; }
};

/// Needs VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT and, for lib/texels.glsl, that of storage too.
struct Texels : Binding {
  Texels(Buffer& from);
};

struct Sampled : Binding {
  Sampled(GpuImage& from, const Sampler& with);
};

/// One level with all its layers.
struct WriteImage : Binding {
  WriteImage(GpuImage& to, std::uint32_t level = 0);
};

/// For shaders whose variant for ray queries takes an acceleration structure instead of texels.
struct TexelsOrRays : Binding {
  TexelsOrRays(Buffer& from);
  TexelsOrRays(AccelerationStructure& through);
};

// NOLINTEND(google-explicit-constructor)

/// Takes the place of a fragment shader if only depth is drawn.
struct NoFragment {
  struct Push {};
  struct Constants {};
  struct Bindings {
    std::array<Binding, 0> list() const { return {}; }
  };
  static Shader shader(ShaderVariant) { return {}; }
};

}  // namespace opaline::gpu
