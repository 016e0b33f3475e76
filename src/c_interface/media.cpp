#include "opaline/media.h"

#include <vector>

#include "c_interface/status.h"
#include "c_interface/values.h"

namespace opaline::c {

namespace {

// Both interfaces number the choices in the same way.
static_assert(static_cast<int>(ColorModel::Khr) == OpalineColorKhr);

const std::vector<Medium>& namedMedia() {
  static const std::vector<Medium> media = [] {
    std::vector<Medium> all;
    for (const MeasuredMedium& measured : measuredMedia()) all.push_back(measured.medium);
    for (const Medium& medium : artisticMedia()) all.push_back(medium);
    return all;
  }();
  return media;
}

OpalineAppearance given(const Appearance& appearance) {
  OpalineAppearance whole{};
  std::copy_n(appearance.color.begin(), 3, whole.color);
  std::copy_n(appearance.meanFreePathMm.begin(), 3, whole.meanFreePathMm);
  whole.g = appearance.g;
  whole.eta = appearance.eta;
  whole.colorModel = static_cast<OpalineColorModel>(appearance.colorModel);
  whole.ballMm = appearance.ballMm;
  return whole;
}

}  // namespace

ColorModel colorModelOf(const OpalineColorModel& given) {
  return choiceOf<ColorModel>(given, OpalineColorKhr, "colour model");
}

Medium mediumOf(const OpalineMedium* given) {
  const OpalineMedium whole = wholeOf(given, {}, "medium");
  Medium medium;
  std::copy_n(whole.sigmaSPrimePerMm, 3, medium.sigmaSPrimePerMm.begin());
  std::copy_n(whole.sigmaAPerMm, 3, medium.sigmaAPerMm.begin());
  medium.eta = whole.eta;
  medium.g = whole.g;
  return sound(medium);
}

void give(const Medium& medium, OpalineMedium* to) {
  OpalineMedium whole{};
  std::copy_n(medium.sigmaSPrimePerMm.begin(), 3, whole.sigmaSPrimePerMm);
  std::copy_n(medium.sigmaAPerMm.begin(), 3, whole.sigmaAPerMm);
  whole.eta = medium.eta;
  whole.g = medium.g;
  give(whole, to, "medium");
}

}  // namespace opaline::c

using namespace opaline;
using opaline::c::guarded;
using opaline::c::required;

extern "C" {

OpalineStatus opalineFindMedium(const char* name, OpalineMedium* medium) {
  return guarded([&] {
    const std::optional<Medium> found = findMedium(&required(name, "name"));
    if (!found) throw UsageError(fmt::format("There is no medium '{}'.", name));
    c::give(*found, medium);
  });
}

size_t opalineMediumCount(void) {
  return c::namedMedia().size();
}

const char* opalineMediumName(size_t index) {
  return index < c::namedMedia().size() ? c::namedMedia()[index].name.c_str() : nullptr;
}

OpalineStatus opalineDefaultAppearance(OpalineAppearance* appearance) {
  return guarded([&] { c::give(c::given(Appearance{}), appearance, "appearance"); });
}

OpalineStatus opalineMediumOfAppearance(const OpalineAppearance* appearance,
                                        OpalineMedium* medium) {
  return guarded([&] {
    const OpalineAppearance whole = c::wholeOf(appearance, c::given(Appearance{}), "appearance");
    Appearance wanted;
    std::copy_n(whole.color, 3, wanted.color.begin());
    std::copy_n(whole.meanFreePathMm, 3, wanted.meanFreePathMm.begin());
    wanted.g = whole.g;
    wanted.eta = whole.eta;
    wanted.colorModel = c::colorModelOf(whole.colorModel);
    wanted.ballMm = whole.ballMm;
    c::give(opaline::mediumOf(c::sound(wanted)), medium);
  });
}

OpalineStatus opalineColorOfMedium(const OpalineMedium* medium, float color[3]) {
  return guarded([&] {
    const Rgb seen = colorOf(c::mediumOf(medium));
    std::copy_n(seen.begin(), 3, &required(color, "color"));
  });
}

}  // extern "C"
