#include "opaline/half_space.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "bssrdf/profile.h"
#include "opaline/error.h"

namespace opaline {

namespace bssrdf {
namespace {

std::array<Profile, 3> checkedProfiles(const Medium& medium, Transport transport, double radiusMm) {
  if (const std::string complaint = complaintAbout(medium); !complaint.empty()) {
    throw UsageError(complaint);
  }
  if (!(radiusMm >= 0)) throw UsageError("The radius must be 0 mm or more.");
  return makeProfiles(modelOf(transport), medium);
}

}  // namespace
}  // namespace bssrdf

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

std::array<double, 3> reflectancePerMm2(const Medium& medium, Transport transport,
                                        double radiusMm) {
  const auto profiles = bssrdf::checkedProfiles(medium, transport, radiusMm);
  return {profiles[0](radiusMm), profiles[1](radiusMm), profiles[2](radiusMm)};
}

std::array<double, 3> reflectanceWithin(const Medium& medium, Transport transport,
                                        double radiusMm) {
  const auto profiles = bssrdf::checkedProfiles(medium, transport, radiusMm);
  return {profiles[0].disc(radiusMm), profiles[1].disc(radiusMm), profiles[2].disc(radiusMm)};
}

}  // namespace opaline
