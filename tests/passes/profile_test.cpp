// The profiles on the device against bssrdf::Profile in double precision.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/vec4.hpp>

#include "bssrdf/profile.h"
#include "gpu/gpu_fixture.h"
#include "gpu/helpers.h"
#include "gpu/pipeline.h"
#include "opaline/media.h"
#include "shaders/profile.comp.h"
#include "shaders/profile_packing.h"

namespace opaline::passes {
namespace {

using bssrdf::Model;
using bssrdf::Profile;

constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;

class ProfileTest : public gpu::GpuTest {
 protected:
  static std::vector<glm::vec4> valuesOnDevice(const std::array<Profile, 3>& profiles,
                                               const std::vector<float>& squaredMm2) {
    const gpu::Compute<shaders::Profile> pipeline(device(), "profile");
    gpu::Buffer packed = gpu::makeBuffer(
        device(), "profile", std::vector<shared::Profile>{shaders::packProfile(profiles)}, storage);
    gpu::Buffer radii = gpu::makeBuffer(device(), "squared radii", squaredMm2, storage);
    gpu::Buffer values =
        gpu::makeBuffer(device(), "values", std::vector<glm::vec4>(squaredMm2.size()), storage);
    const auto count = static_cast<std::uint32_t>(squaredMm2.size());
    gpu::CommandList commands(device(), "profile");
    commands.begin();
    commands.bind(pipeline, {.packed = packed, .squaredMm2 = radii, .values = values},
                  {.count = count, .better = profiles[0].model == Model::BetterDipole});
    commands.dispatchLinear(count);
    commands.submit();
    commands.wait();
    return gpu::readAs<glm::vec4>(device(), values);
  }

  static void expectSame(const Medium& medium, Model model) {
    std::array<Profile, 3> exact;
    for (int c = 0; c < 3; ++c)
      exact[static_cast<std::size_t>(c)] =
          bssrdf::makeProfile(model, bssrdf::coefficients(medium, c));
    for (std::size_t c = 0; c < 3; ++c) {
      // Without absorption there is no diffusion length; a thousand mean free paths stand in.
      const double farMm =
          exact[c].sigmaTrPerMm > 0 ? 20 / exact[c].sigmaTrPerMm : 1000 * exact[c].zRealMm;
      std::vector<float> squared;
      for (double r = 0; r <= farMm; r = r * 1.02 + 1e-4 * farMm)
        squared.push_back(static_cast<float>(r * r));
      const std::vector<glm::vec4> values = valuesOnDevice(exact, squared);
      for (std::size_t i = 0; i < squared.size(); ++i) {
        const double radiusMm = std::sqrt(static_cast<double>(squared[i]));
        ASSERT_NEAR(static_cast<double>(values[i][static_cast<int>(c)]) / exact[c](radiusMm), 1,
                    1e-5)
            << medium.name << ", channel " << c << ", r " << radiusMm << " mm";
      }
    }
  }
};

TEST_F(ProfileTest, DipoleOfEveryMeasuredMedium) {
  for (const MeasuredMedium& row : measuredMedia()) expectSame(row.medium, Model::Dipole);
}

TEST_F(ProfileTest, BetterDipoleOfEveryMeasuredMedium) {
  for (const MeasuredMedium& row : measuredMedia()) expectSame(row.medium, Model::BetterDipole);
}

TEST_F(ProfileTest, StrongAbsorptionAndOtherIndices) {
  for (const double eta : {1.01, 1.8, 3.0}) {
    const Medium medium{"dark", {.5, 1, 20}, {5, .5, 1e-3}, eta};
    expectSame(medium, Model::Dipole);
    expectSame(medium, Model::BetterDipole);
  }
}

}  // namespace
}  // namespace opaline::passes
