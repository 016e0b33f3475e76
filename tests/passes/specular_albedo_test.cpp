#include "passes/shade/specular_albedo.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bssrdf/fresnel.h"

namespace opaline::passes {
namespace {

// Walter et al. 2007, Eq. 4 and 20, with Smith's height-correlated G (Heitz 2014, Eq. 99): the
// integral of the BRDF times the cosine over all half-vectors, on a grid that is even in the
// measure D cos dω, tan²θ = α² u/(1-u).
double byHalfVectors(double eta, double alpha, double cosine) {
  constexpr int rings = 2000;
  constexpr int sectors = 180;
  const auto lambda = [&](double c) {
    return 0.5 * (std::sqrt(1 + alpha * alpha * (1 - c * c) / (c * c)) - 1);
  };
  const double sine = std::sqrt(1 - cosine * cosine);
  double sum = 0;
  for (int i = 0; i < rings; ++i) {
    const double u = (i + 0.5) / rings;
    const double tangent = alpha * std::sqrt(u / (1 - u));
    const double cosineNormal = 1 / std::sqrt(1 + tangent * tangent);
    for (int j = 0; j < sectors; ++j) {
      const double angle = (j + 0.5) * std::numbers::pi / sectors;  // the other half mirrors it
      const double cosineHalf = cosineNormal * (cosine + sine * tangent * std::cos(angle));
      const double cosineIn = 2 * cosineHalf * cosineNormal - cosine;
      if (cosineHalf <= 0 || cosineIn <= 0) continue;
      sum += bssrdf::fresnelReflectance(eta, std::min(cosineHalf, 1.0)) * cosineHalf /
             (cosine * cosineNormal * (1 + lambda(cosine) + lambda(cosineIn)));
    }
  }
  return sum / (rings * sectors);
}

double cosineOf(int entry) {
  return (entry + 0.5) / specularAlbedoEntries;
}

TEST(SpecularAlbedo, AgreesWithQuadratureOverHalfVectors) {
  for (const double eta : {1.3, 1.5, 2.5})
    for (const double roughness : {0.05, 0.25, 0.6, 1.0}) {
      const std::vector<float> albedo = specularAlbedo(eta, roughness);
      ASSERT_EQ(albedo.size(), static_cast<std::size_t>(specularAlbedoEntries));
      for (const int entry : {0, 1, 4, 10, 25, 45, 63})
        EXPECT_NEAR(static_cast<double>(albedo[static_cast<std::size_t>(entry)]),
                    byHalfVectors(eta, roughness * roughness, cosineOf(entry)), 0.002)
            << "η " << eta << ", roughness " << roughness << ", cosine " << cosineOf(entry);
    }
}

TEST(SpecularAlbedo, SmoothLimitIsFresnel) {
  const std::vector<float> albedo = specularAlbedo(1.5, 1e-3);
  for (int i = 1; i < specularAlbedoEntries; ++i)
    EXPECT_NEAR(static_cast<double>(albedo[static_cast<std::size_t>(i)]),
                bssrdf::fresnelReflectance(1.5, cosineOf(i)), 1e-4);
}

TEST(SpecularAlbedo, NeverMoreThanArrives) {
  for (const double eta : {1.01, 1.5, 3.0})
    for (const double roughness : {0.05, 0.5, 1.0})
      for (const float value : specularAlbedo(eta, roughness)) {
        EXPECT_GE(value, 0.0F);
        EXPECT_LE(value, 1.0F);
      }
}

}  // namespace
}  // namespace opaline::passes
