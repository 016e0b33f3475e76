#include "opaline/media.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "bssrdf/profile.h"

namespace opaline::bssrdf {
namespace {

TEST(MeasuredMedia, AreTwelve) {
  EXPECT_EQ(measuredMedia().size(), 12U);
}

// Jensen et al. 2001, Figure 5, last column. The values are rounded measurements, which the dipole
// explains to about ±0.015.
TEST(MeasuredMedia, DipoleGivesThePublishedReflectance) {
  for (const MeasuredMedium& row : measuredMedia()) {
    for (int c = 0; c < 3; ++c) {
      if (row.medium.name == "chicken1" && c == 2) continue;  // inconsistent in the table itself
      const double total =
          makeProfile(Model::Dipole, coefficients(row.medium, c)).totalReflectance();
      EXPECT_NEAR(total, row.diffuseReflectance[static_cast<std::size_t>(c)], 0.015)
          << row.medium.name << ' ' << c;
    }
  }
}

TEST(Media, NamesDiffer) {
  std::set<std::string> names;
  for (const MeasuredMedium& row : measuredMedia()) names.insert(row.medium.name);
  for (const Medium& medium : artisticMedia()) names.insert(medium.name);
  EXPECT_EQ(names.size(), measuredMedia().size() + artisticMedia().size());
}

TEST(ArtisticMedia, LetLightThroughABodyOf50Millimetres) {
  for (const Medium& medium : artisticMedia()) {
    EXPECT_GE(medium.eta, 1.01);
    EXPECT_LE(medium.eta, 3.0);
    double longestDiffusionLengthMm = 0;
    for (int c = 0; c < 3; ++c) {
      const Profile profile = makeProfile(Model::Dipole, coefficients(medium, c));
      longestDiffusionLengthMm = std::max(longestDiffusionLengthMm, 1 / profile.sigmaTrPerMm);
      EXPECT_GT(profile.totalReflectance(), 0.0);
      EXPECT_LT(profile.totalReflectance(), 1.0);
    }
    EXPECT_GT(longestDiffusionLengthMm, 5.0) << medium.name;
  }
}

TEST(FindMedium, IgnoresCaseAndKnowsBothTables) {
  ASSERT_TRUE(findMedium("MarBle"));
  EXPECT_EQ(findMedium("marble")->name, "marble");
  EXPECT_EQ(findMedium("marble")->eta, 1.5);
  EXPECT_EQ(findMedium("chicken1")->sigmaAPerMm[0], 0.015);
  for (const char* name : {"jade", "wax", "gummy-red", "gummy-green", "gummy-orange", "Soap"}) {
    EXPECT_TRUE(findMedium(name)) << name;
  }
  EXPECT_FALSE(findMedium("marbl"));
  EXPECT_FALSE(findMedium(""));
}

}  // namespace
}  // namespace opaline::bssrdf
