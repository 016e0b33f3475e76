#pragma once

#include <array>
#include <limits>
#include <optional>

#include "opaline/export.h"
#include "opaline/medium.h"
#include "opaline/render_options.h"

namespace opaline {

/// How far light travels in a medium, in millimetres, per channel.
struct MediumLengths {
  std::array<double, 3> meanFreePathMm{};  ///< 1/σ_t' = 1/(σ_s' + σ_a)
  std::array<double, 3> diffusionMm{};  ///< 1/σ_tr = 1/√(3 σ_a σ_t'); infinite without absorption
  std::optional<double> longestDiffusionMm;  ///< the longest finite one; none if no channel absorbs
};

/// The lengths of a valid medium. A body less than about ten diffusion lengths across looks like
/// fog, one of hundreds like chalk.
OPALINE_API MediumLengths lengthsOf(const Medium& medium);

/// The diffuse reflectance R_d(r) of a half-space, mm⁻², per channel: of the light that enters at
/// one point, the share per area that leaves again at that distance. It follows Jensen et al. 2001,
/// Eq. 4 for Transport::Dipole and d'Eon 2012 for Transport::BetterDipole. Transport::Boundary,
/// which solves for a body's own shape, takes its fine detail from the latter. Throws UsageError
/// for a medium that cannot be rendered and for a radius below 0.
OPALINE_API std::array<double, 3> reflectancePerMm2(const Medium& medium, Transport transport,
                                                    double radiusMm);

/// The integral of R_d over a disc of that radius, in [0, 1]. By default it is the total diffuse
/// reflectance, the colour of an evenly lit half-space. Throws like reflectancePerMm2().
OPALINE_API std::array<double, 3> reflectanceWithin(
    const Medium& medium, Transport transport,
    double radiusMm = std::numeric_limits<double>::infinity());

}  // namespace opaline
