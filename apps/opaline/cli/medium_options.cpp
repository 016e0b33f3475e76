#include "cli/medium_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "bssrdf/media.h"
#include "bssrdf/profile.h"
#include "cli/values.h"
#include "opaline/error.h"

namespace opaline::app {

namespace {

constexpr Range coefficientRange{0, 1e4, "per mm"};
constexpr double leastExtinctionPerMm = 1e-4;

Medium namedMedium(const Given& given) {
  if (auto medium = bssrdf::findMedium(given.text)) return *medium;
  std::vector<std::string> names;
  for (const auto& row : bssrdf::measuredMedia()) names.push_back(row.medium.name);
  for (const Medium& medium : bssrdf::artisticMedia()) names.push_back(medium.name);
  throw UsageError(fmt::format("{} {}: there is no such medium{}; opaline media lists them",
                               given.option, given.text, suggestion(given.text, names)));
}

}  // namespace

void MediumOptions::addTo(CommandLine& line) {
  line.value("--medium", "NAME", "one that opaline media lists",
             [this](const Given& given) { named_ = namedMedium(given); });
  line.value(
      "--sigma-s", "R,G,B", "reduced scattering and absorption, 1/mm",
      [this](const Given& given) { sigmaSPrimePerMm_ = readChannels(given, coefficientRange); });
  line.value("--sigma-a", "R,G,B", "",
             [this](const Given& given) { sigmaAPerMm_ = readChannels(given, coefficientRange); });
  line.value("--eta", "X", "index of refraction, 1.01 to 3 [1.3]", [this](const Given& given) {
    eta_ = readNumber(given, {1.01, 3});
  });
}

std::optional<Medium> MediumOptions::medium() const {
  if (!sigmaSPrimePerMm_ && !sigmaAPerMm_) {
    if (eta_) {
      throw UsageError("--eta belongs to --sigma-s and --sigma-a; a named medium has its own");
    }
    return named_;
  }
  if (named_) throw UsageError("--medium and --sigma-s or --sigma-a exclude each other");
  if (!sigmaAPerMm_) throw UsageError("--sigma-s needs --sigma-a beside it");
  if (!sigmaSPrimePerMm_) throw UsageError("--sigma-a needs --sigma-s beside it");
  for (std::size_t channel = 0; channel < 3; ++channel) {
    if (!((*sigmaSPrimePerMm_)[channel] > 0)) {
      throw UsageError("--sigma-s must be above 0 per mm in every channel");
    }
    if ((*sigmaSPrimePerMm_)[channel] + (*sigmaAPerMm_)[channel] < leastExtinctionPerMm) {
      throw UsageError(
          fmt::format("--sigma-s plus --sigma-a must be at least {} per mm in every channel",
                      leastExtinctionPerMm));
    }
  }
  return Medium{"custom", *sigmaSPrimePerMm_, *sigmaAPerMm_, eta_.value_or(1.3)};
}

MediumLengths lengthsOf(const Medium& medium) {
  MediumLengths lengths;
  for (int channel = 0; channel < 3; ++channel) {
    const auto index = static_cast<std::size_t>(channel);
    const bssrdf::Coefficients c = bssrdf::coefficients(medium, channel);
    const double sigmaTr = bssrdf::makeProfile(bssrdf::Model::Dipole, c).sigmaTrPerMm;
    lengths.meanFreePathMm[index] = c.meanFreePathMm;
    lengths.diffusionMm[index] =
        sigmaTr > 0 ? 1 / sigmaTr : std::numeric_limits<double>::infinity();
    if (sigmaTr > 0) {
      lengths.longestDiffusionMm =
          std::max(lengths.longestDiffusionMm.value_or(0), lengths.diffusionMm[index]);
    }
  }
  return lengths;
}

}  // namespace opaline::app
