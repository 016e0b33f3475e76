#include "opaline/half_space.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "opaline/error.h"
#include "opaline/media.h"

namespace opaline {
namespace {

constexpr Transport profiles[] = {Transport::Dipole, Transport::BetterDipole};

TEST(HalfSpaceFunctions, LengthsAreThoseOfTheCoefficients) {
  // Marble, Jensen et al. 2001, Figure 5.
  const MediumLengths marble = lengthsOf(findMedium("marble").value());
  EXPECT_NEAR(marble.meanFreePathMm[1], 1 / (2.62 + 0.0041), 1e-12);
  EXPECT_NEAR(marble.diffusionMm[1], 1 / std::sqrt(3 * 0.0041 * (2.62 + 0.0041)), 1e-9);
  EXPECT_EQ(marble.longestDiffusionMm, marble.diffusionMm[0]) << "red is absorbed least";

  const Medium clear{
      .name = {}, .sigmaSPrimePerMm = {1, 2, 4}, .sigmaAPerMm = {0, 0, 0.5}, .eta = 1.3};
  const MediumLengths lengths = lengthsOf(clear);
  EXPECT_TRUE(std::isinf(lengths.diffusionMm[0]));
  EXPECT_EQ(lengths.longestDiffusionMm, lengths.diffusionMm[2]) << "of those that are finite";
  EXPECT_FALSE(
      lengthsOf({.name = {}, .sigmaSPrimePerMm = {1, 1, 1}, .sigmaAPerMm = {}}).longestDiffusionMm);
}

// 2π ∫ R_d(r) r dr, by Simpson's rule in ln r.
double integral(const Medium& medium, Transport transport, double radiusMm) {
  constexpr int steps = 4000;
  const double from = std::log(1e-7 * radiusMm);
  const double width = (std::log(radiusMm) - from) / steps;
  double sum = 0;
  for (int i = 0; i <= steps; ++i) {
    const double r = std::exp(from + i * width);
    const double weight = i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2;
    sum += weight * r * r * reflectancePerMm2(medium, transport, r)[1];
  }
  return 2 * std::numbers::pi * sum * width / 3;
}

TEST(HalfSpaceFunctions, ADiscHasTheIntegralOfTheProfile) {
  for (const char* name : {"marble", "skin1", "ketchup"})
    for (const Transport transport : profiles)
      for (const double radiusMm : {0.1, 1., 30.}) {
        const Medium medium = findMedium(name).value();
        EXPECT_NEAR(reflectanceWithin(medium, transport, radiusMm)[1],
                    integral(medium, transport, radiusMm), 1e-5)
            << name << " within " << radiusMm;
      }
}

// Jensen et al. 2001, Eq. 4, integrated over the plane: without absorption all light returns.
TEST(HalfSpaceFunctions, WithoutAbsorptionAllLightReturns) {
  const Medium clear{.name = {}, .sigmaSPrimePerMm = {0.1, 1, 100}, .sigmaAPerMm = {}, .eta = 1.4};
  for (const double total : reflectanceWithin(clear, Transport::Dipole))
    EXPECT_NEAR(total, 1, 1e-9);
  const Medium marble = findMedium("marble").value();
  for (const Transport transport : profiles) {
    double least = 0;
    for (const double radiusMm : {0., 0.5, 2., 8., 1e3}) {
      const double share = reflectanceWithin(marble, transport, radiusMm)[0];
      EXPECT_GE(share, least);
      least = share;
    }
    EXPECT_EQ(reflectanceWithin(marble, transport, 0)[0], 0);
    EXPECT_LT(least, 1);
    EXPECT_NEAR(reflectanceWithin(marble, transport)[0], least, 1e-6);
  }
}

TEST(HalfSpaceFunctions, RefusesWhatMakesNoSense) {
  const Medium marble = findMedium("marble").value();
  EXPECT_THROW(reflectancePerMm2(marble, Transport::Dipole, -1), UsageError);
  EXPECT_THROW(reflectanceWithin(marble, Transport::Dipole, NAN), UsageError);
  EXPECT_THROW(reflectancePerMm2(Medium{}, Transport::Dipole, 1), UsageError);
}

}  // namespace
}  // namespace opaline
