#pragma once

#include <cstddef>
#include <vector>

#include "opaline/renderer.h"
#include "passes/products.h"
#include "renderer/scene/scene_resources.h"
#include "shaders/shared/frame.h"
#include "shaders/shared/medium.h"

namespace opaline::gpu {
class Device;
}

namespace opaline {

/// The tables of bodies and media as they were uploaded.
struct TablesOnHost {
  std::vector<shared::ObjectData> objects;
  std::vector<shared::MediumData> media;
};

/// Makes the shaders' tables of bodies and media on the device. They depend on the options'
/// transport and roughness. For set-up, not for frames.
passes::SceneTables makeSceneTables(gpu::Device& device, const SceneResources& resources,
                                    const RenderOptions& options, TablesOnHost& onHost);

/// Sets what depends on the coefficients of a medium; its index of refraction must not change.
/// Allocates nothing.
void setMedium(const Medium& medium, Transport transport, shared::MediumData& data);

/// The same for an object that is made of the medium.
void setMediumOf(const SceneResources& resources, std::size_t object, const Medium& medium,
                 Transport transport, shared::ObjectData& data);

/// Lobes for a roughness by the cosine of the view; there are reflectionLobeEntries.
std::vector<shared::vec4> reflectionLobes(double roughness);

}  // namespace opaline
