#pragma once

#include <optional>

#include "reference/geometry.h"
#include "reference/vector.h"

namespace opaline::reference {

/// The normal texture of an opaque body, or of a translucent body's surface.
const std::optional<Texture>& normalTextureOf(const Body& body);

/// The normal from the body's normal texture where the mesh has the normal `ofMesh`; without a
/// texture `ofMesh` itself.
Vector normalAt(const Body& body, const SurfacePoint& point, const Vector& ofMesh);

/// Roughness² of a translucent body's surface. `standard` is the roughness where the body has none
/// of its own.
double alphaAt(const Body& body, const SurfacePoint& point, double standard);

}  // namespace opaline::reference
