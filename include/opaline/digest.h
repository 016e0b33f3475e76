#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "opaline/export.h"
#include "opaline/scene.h"

namespace opaline {

/// A number that reveals accidental changes of a scene, but no forgery: the 64-bit FNV-1a hash
/// (Fowler, Noll and Vo 1991) of all that its pictures depend on, without names and notes. Together
/// with RenderOptions and the time it tells whether a stored picture is still up to date. Other
/// versions of the library may have another number for the same scene.
OPALINE_API std::uint64_t digestOf(const Scene& scene);

/// The same hash of any bytes.
OPALINE_API std::uint64_t digestOf(std::span<const std::byte> bytes);

}  // namespace opaline
