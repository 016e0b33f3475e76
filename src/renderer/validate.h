#pragma once

#include <cstddef>
#include <vector>

#include "opaline/renderer.h"
#include "opaline/scene.h"

namespace opaline {

/// Throws UsageError that names the option, its value and its range.
void validate(const RenderOptions& options);

/// The same for a variable that frames with these options cannot have.
void validate(const RenderOptions& options, const std::vector<Aov>& aovs);

/// Throws Error for a scene that cannot be rendered: no triangles, indices out of range, numbers
/// that are not finite, media out of range, more lights than there may be.
void validate(const Scene& scene);

/// The same for parts of a scene.
void validate(const Camera& camera);
void validate(const Lighting& lighting);
void validate(const Medium& medium);
/// The same for the material of an object with that name.
void validate(const std::string& object, const Material& material);
void validate(const std::vector<Deformer>& deformers);

/// Throws UsageError unless `object` is below `count`.
void requireObject(std::size_t object, std::size_t count);

/// The part of validate(scene) for nodes, clips, rigs and deformers.
void validateMotion(const Scene& scene);

}  // namespace opaline
