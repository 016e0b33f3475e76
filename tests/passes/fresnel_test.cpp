// Fresnel's reflectance on the device against bssrdf in double precision.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <glm/vec2.hpp>

#include "bssrdf/fresnel.h"
#include "gpu/gpu_fixture.h"
#include "gpu/helpers.h"
#include "gpu/pipeline.h"
#include "shaders/fresnel.comp.h"

namespace opaline::passes {
namespace {

using FresnelTest = gpu::GpuTest;

TEST_F(FresnelTest, ReflectanceIsExact) {
  std::vector<glm::vec2> places;
  for (const double eta : {1.01, 1.1, 1.3, 1.5, 2.0, 3.0})
    for (int i = 0; i <= 1000; ++i) places.emplace_back(eta, i / 1000.0);

  constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  const gpu::Compute<shaders::Fresnel> pipeline(device(), "fresnel");
  gpu::Buffer input = gpu::makeBuffer(device(), "places", places, storage);
  gpu::Buffer output =
      gpu::makeBuffer(device(), "values", std::vector<float>(places.size()), storage);
  gpu::CommandList commands(device(), "fresnel");
  commands.begin();
  commands.bind(pipeline, {.etaCosine = input, .values = output},
                {.count = static_cast<std::uint32_t>(places.size())});
  commands.dispatchLinear(static_cast<std::uint32_t>(places.size()));
  commands.submit();
  commands.wait();

  const auto values = gpu::readAs<float>(device(), output);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto eta = static_cast<double>(places[i].x);
    const auto cosine = static_cast<double>(places[i].y);
    const double expected = bssrdf::fresnelReflectance(eta, cosine);
    // Amplitudes, whose difference carries the rounding, enter squared.
    const double rounding = 2e-6 * std::sqrt(expected) + 1e-10;
    ASSERT_NEAR(static_cast<double>(values[i]), expected, rounding) << eta << ' ' << cosine;
  }
}

}  // namespace
}  // namespace opaline::passes
