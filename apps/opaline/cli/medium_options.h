#pragma once

#include <array>
#include <optional>
#include <string>

#include "cli/command_line.h"
#include "opaline/medium.h"

namespace opaline::app {

/// --medium, or --sigma-s, --sigma-a and --eta.
class MediumOptions {
 public:
  void addTo(CommandLine& line);
  bool any() const { return named_ || sigmaSPrimePerMm_ || sigmaAPerMm_ || eta_; }
  /// What was asked for; nothing when no such option was given. Throws UsageError for a mixture
  /// that describes no medium.
  std::optional<Medium> medium() const;

 private:
  std::optional<Medium> named_;
  std::optional<std::array<double, 3>> sigmaSPrimePerMm_;
  std::optional<std::array<double, 3>> sigmaAPerMm_;
  std::optional<double> eta_;
};

/// Lengths that follow from a medium, per channel.
struct MediumLengths {
  std::array<double, 3> meanFreePathMm{};  ///< 1/σ_t' = z_r
  std::array<double, 3> diffusionMm{};     ///< 1/σ_tr; infinite without absorption
  /// The longest finite one of diffusionMm; nothing where no channel absorbs.
  std::optional<double> longestDiffusionMm;
};

MediumLengths lengthsOf(const Medium& medium);

}  // namespace opaline::app
