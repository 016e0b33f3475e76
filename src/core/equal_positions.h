#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "opaline/types.h"

namespace opaline::core {

/// For every position the index of the first equal one.
std::vector<std::uint32_t> equalPositions(std::span<const Vec3> positions);

}  // namespace opaline::core
