#pragma once

#include <cstddef>
#include <vector>

#include "opaline/renderer.h"
#include "opaline/scene.h"

namespace opaline {

/// Throws UsageError that names the option, its value and its range.
void validate(const RenderOptions& options);

/// The same for a variable that no frame with these options has.
void validate(const RenderOptions& options, const std::vector<Aov>& aovs);

/// Throws Error for a scene that cannot be rendered: no triangles, indices out of range, numbers
/// that are not finite, media out of range, more lights than there may be.
void validate(const Scene& scene);

/// As a scene's, of its parts.
void validate(const Camera& camera);
void validate(const Lighting& lighting);
void validate(const Medium& medium);
/// Of an object of that name.
void validate(const std::string& object, const Material& material);
void validate(const std::vector<Deformer>& deformers);

/// Throws UsageError for an object that a scene with so many does not have.
void requireObject(std::size_t object, std::size_t count);

/// The part of it that speaks of nodes, clips, rigs and deformers.
void validateMotion(const Scene& scene);

}  // namespace opaline
