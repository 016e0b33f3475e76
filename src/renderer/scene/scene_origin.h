#pragma once

#include "opaline/scene.h"

namespace opaline {

/// Floats far from zero are coarse: at 10 m they are 1 µm apart. So a scene that is far from the
/// origin for its size is rendered as if its middle were at the origin. Returns that middle, or
/// zero for scenes near the origin.
Vec3 originFor(const Scene& scene);

/// Make places relative to `originMm`.
void seeFrom(const Vec3& originMm, Vec3& positionMm);
void seeFrom(const Vec3& originMm, Camera& camera);
void seeFrom(const Vec3& originMm, Lighting& lighting);
void seeFrom(const Vec3& originMm, Mesh& mesh);

}  // namespace opaline
