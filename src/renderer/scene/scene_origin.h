#pragma once

#include "opaline/scene.h"

namespace opaline {

/// Floats far from zero are coarse: at 10 m they are 1 µm apart. So what lies far from the origin
/// for its size is rendered as if its middle were there. Zero for scenes that lie near it.
Vec3 originFor(const Scene& scene);

/// Say where they are from there on.
void seeFrom(const Vec3& originMm, Vec3& positionMm);
void seeFrom(const Vec3& originMm, Camera& camera);
void seeFrom(const Vec3& originMm, Lighting& lighting);
void seeFrom(const Vec3& originMm, Mesh& mesh);

}  // namespace opaline
