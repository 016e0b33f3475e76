#pragma once

#include <array>
#include <vector>

namespace opaline::passes {

/// The share of light from everywhere that GGX surfaces mirror, as factors of F₀ and of F₉₀
/// (Schlick 1994), at the roughnesses (i + ½)/32 and, for each, the cosines (j + ½)/32 of the view.
/// The error is below 0.004.
std::vector<std::array<float, 2>> glossTable();

}  // namespace opaline::passes
