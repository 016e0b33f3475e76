#pragma once

#include <optional>

#include "reference/geometry.h"
#include "reference/vector.h"

namespace opaline::reference {

/// Of an opaque body or of the surface of a translucent one.
const std::optional<Texture>& normalTextureOf(const Body& body);

/// The normal that the body's normal texture tells where that of the mesh is `ofMesh`; without a
/// texture, that one.
Vector normalAt(const Body& body, const SurfacePoint& point, const Vector& ofMesh);

/// Roughness² of a translucent body's surface; `standard` is the roughness where it states none.
double alphaAt(const Body& body, const SurfacePoint& point, double standard);

}  // namespace opaline::reference
