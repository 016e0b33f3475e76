#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "opaline/export.h"
#include "opaline/scene.h"

namespace opaline {

/// A number that tells whether a scene changed by mistake, not whether it was forged: FNV-1a of 64
/// bits (Fowler, Noll and Vo 1991) of all that decides its pictures, and not of names and notes.
/// With RenderOptions and the time it tells whether a picture that is kept somewhere is still that
/// of its scene. Other versions of the library may have another number for the same scene.
OPALINE_API std::uint64_t digestOf(const Scene& scene);

/// The same of any bytes.
OPALINE_API std::uint64_t digestOf(std::span<const std::byte> bytes);

}  // namespace opaline
