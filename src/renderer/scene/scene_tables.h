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

/// What the tables of bodies and media were made of.
struct TablesOnHost {
  std::vector<shared::ObjectData> objects;
  std::vector<shared::MediumData> media;
};

/// Puts what the shaders know of bodies and media on the device. It depends on the options'
/// transport and roughness; for set-up, not for frames.
passes::SceneTables makeSceneTables(gpu::Device& device, const SceneResources& resources,
                                    const RenderOptions& options, TablesOnHost& onHost);

/// Sets what depends on the coefficients of a medium, whose index of refraction stays. Allocates
/// nothing.
void setMedium(const Medium& medium, Transport transport, shared::MediumData& data);

/// The same of an object that is made of it.
void setMediumOf(const SceneResources& resources, std::size_t object, const Medium& medium,
                 Transport transport, shared::ObjectData& data);

/// Lobes of that roughness by the cosine of the view, reflectionLobeEntries of them.
std::vector<shared::vec4> reflectionLobes(double roughness);

}  // namespace opaline
