// Triangles drawn by invocations (lib/raster.glsl) against lines of sight in double precision.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "gpu/gpu_fixture.h"
#include "gpu/helpers.h"
#include "gpu/pipeline.h"
#include "passes/raster.h"
#include "shaders/scatter/nearest_triangles.comp.h"
#include "shaders/shared/frame.h"

namespace opaline::passes {
namespace {

constexpr std::uint32_t size = 32;  // of the picture

using Triangles = std::vector<std::array<glm::vec3, 3>>;

// Seen from the origin along z: clip space is x, y, `depth` applied to 1 and z, and z.
glm::mat4 alongZ(glm::vec2 depth) {
  glm::mat4 matrix(0);
  matrix[0][0] = matrix[1][1] = 1;
  matrix[3][2] = depth.x;
  matrix[2][2] = depth.y;
  matrix[2][3] = 1;
  return matrix;
}

class RasterTest : public gpu::GpuTest {
 protected:
  // The triangle that each sample sees, or none.
  std::vector<std::optional<std::size_t>> draw(const Triangles& triangles,
                                               const std::vector<glm::vec2>& samples,
                                               const glm::mat4& toClip) {
    constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    std::vector<shared::FrameData> frame(1);
    frame[0].worldToClip = toClip;
    for (std::size_t s = 0; s < samples.size(); ++s)
      frame[0].samples[s] = glm::vec4(samples[s], 0, 0);
    std::vector<glm::vec4> positions;
    std::vector<std::uint32_t> indices;
    for (const auto& triangle : triangles)
      for (const glm::vec3& corner : triangle) {
        indices.push_back(static_cast<std::uint32_t>(positions.size()));
        positions.emplace_back(corner, 1);
      }
    gpu::Buffer frames =
        gpu::makeBuffer(device(), "frame", frame, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    gpu::Buffer indexBuffer = gpu::makeBuffer(device(), "indices", indices, storage);
    gpu::Buffer positionBuffer = gpu::makeBuffer(device(), "positions", positions, storage);
    const std::vector<std::uint32_t> nothing(samples.size() * size * size);
    gpu::Buffer depths = gpu::makeBuffer(device(), "depths", nothing, storage);
    gpu::Buffer nearest = gpu::makeBuffer(device(), "nearest triangles", nothing, storage);
    const auto count = static_cast<std::uint32_t>(triangles.size());
    const RasterBands bands = rasterBands(count, size);
    const gpu::Compute<shaders::ScatterNearestTriangles> pipeline(device(), "nearest triangles");
    gpu::CommandList commands(device(), "raster");
    commands.begin();
    for (const std::uint32_t findsTriangles : {0U, 1U}) {
      commands.bind(pipeline,
                    {.frame = frames,
                     .indices = indexBuffer,
                     .positions = positionBuffer,
                     .depths = depths,
                     .triangles = nearest},
                    {.width = size,
                     .height = size,
                     .samples = static_cast<std::uint32_t>(samples.size()),
                     .triangleCount = count,
                     .rowsOfBand = bands.rows,
                     .findsTriangles = findsTriangles});
      commands.dispatch(bands.groups, bands.count);
    }
    commands.submit();
    commands.wait();
    std::vector<std::optional<std::size_t>> seen;
    for (const std::uint32_t word : gpu::readAs<std::uint32_t>(device(), nearest))
      seen.push_back(word == 0 ? std::nullopt : std::optional<std::size_t>(~word));
    return seen;
  }

  // The same, drawn in reverse order.
  std::vector<std::optional<std::size_t>> drawBackwards(Triangles triangles,
                                                        const std::vector<glm::vec2>& samples,
                                                        const glm::mat4& toClip) {
    std::reverse(triangles.begin(), triangles.end());
    std::vector<std::optional<std::size_t>> seen = draw(triangles, samples, toClip);
    for (std::optional<std::size_t>& triangle : seen)
      if (triangle) triangle = triangles.size() - 1 - *triangle;
    return seen;
  }

  // A sample in two of these triangles sees either the first or the last, as all are equally near.
  void expectEachSampleOnce(const Triangles& triangles, const std::vector<glm::vec2>& samples) {
    const glm::mat4 evenDepth = alongZ({0, 0.5F});
    const auto forwards = draw(triangles, samples, evenDepth);
    EXPECT_EQ(std::count(forwards.begin(), forwards.end(), std::nullopt), 0);
    EXPECT_EQ(forwards, drawBackwards(triangles, samples, evenDepth));
  }
};

const std::vector<glm::vec2> inMiddle{{0, 0}};
const std::vector<glm::vec2> four{
    {-0.125F, -0.375F}, {0.375F, -0.125F}, {-0.375F, 0.125F}, {0.125F, 0.375F}};

float clipOf(float pixels) {
  return 2 * pixels / size - 1;
}

// All edges, including oblique ones, pass through samples of pixels.
TEST_F(RasterTest, SamplesOnEdgesAreSeenOnce) {
  std::vector<float> lines{-1};
  for (float pixels = 2.5F; pixels < size; pixels += 3) lines.push_back(clipOf(pixels));
  lines.push_back(1);
  for (const bool turned : {false, true}) {
    Triangles triangles;
    for (std::size_t y = 0; y + 1 < lines.size(); ++y)
      for (std::size_t x = 0; x + 1 < lines.size(); ++x) {
        const glm::vec3 a(lines[x], lines[y], 1);
        const glm::vec3 b(lines[x + 1], lines[y], 1);
        const glm::vec3 c(lines[x + 1], lines[y + 1], 1);
        const glm::vec3 d(lines[x], lines[y + 1], 1);
        triangles.push_back(turned ? std::array{a, b, d} : std::array{c, b, a});
        triangles.push_back(turned ? std::array{d, b, c} : std::array{a, d, c});
      }
    expectEachSampleOnce(triangles, inMiddle);
  }
}

TEST_F(RasterTest, AFanHasNoHolesWhereverItsCornersAre) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<float> place(-1, 1);
  std::uniform_real_distribution<float> distance(0.01F, 100);
  for (int k = 0; k < 10; ++k) {
    const glm::vec2 middle =
        k == 0 ? glm::vec2(clipOf(16.5F)) : glm::vec2(place(generator), place(generator));
    constexpr std::size_t corners = 41;
    const auto at = [](glm::vec2 seen, float z) { return glm::vec3(seen * z, z); };
    std::vector<glm::vec3> around;
    for (std::size_t i = 0; i < corners; ++i) {
      const float angle = 6.2831853F * static_cast<float>(i) / corners;
      around.push_back(at(3.0F * glm::vec2(std::cos(angle), std::sin(angle)), distance(generator)));
    }
    Triangles triangles;
    const glm::vec3 hub = at(middle, distance(generator));
    for (std::size_t i = 0; i < corners; ++i)
      triangles.push_back({hub, around[i], around[(i + 1) % corners]});
    expectEachSampleOnce(triangles, k % 2 == 0 ? inMiddle : four);
  }
}

struct Meeting {
  double z = 1e30;    // along the line of sight
  double inside = 0;  // distance from the triangle's edges, relative to its size
};

// Möller and Trumbore 1997.
Meeting meet(const std::array<glm::vec3, 3>& triangle, glm::dvec3 sight) {
  const glm::dvec3 a(triangle[0]);
  const glm::dvec3 along = glm::dvec3(triangle[1]) - a;
  const glm::dvec3 across = glm::dvec3(triangle[2]) - a;
  const glm::dvec3 p = glm::cross(sight, across);
  const double determinant = glm::dot(along, p);
  const glm::dvec3 q = glm::cross(-a, along);
  const double u = glm::dot(-a, p) / determinant;
  const double v = glm::dot(sight, q) / determinant;
  return {glm::dot(across, q) / determinant, std::min({u, v, 1 - u - v})};
}

TEST_F(RasterTest, WhatIsNearestIsSeenAlsoOfTrianglesThatReachBehindTheCamera) {
  constexpr double nearest = 0.05;
  std::mt19937 generator(5);
  std::uniform_real_distribution<float> beside(-2, 2);
  std::uniform_real_distribution<float> ahead(-1, 3);
  std::uniform_real_distribution<float> little(-0.1F, 0.1F);
  Triangles triangles;
  for (int i = 0; i < 400; ++i) {
    const auto anywhere = [&] {
      return glm::vec3(beside(generator), beside(generator), ahead(generator));
    };
    const glm::vec3 first = anywhere();
    const auto nearby = [&] {
      return first + glm::vec3(little(generator), little(generator), little(generator));
    };
    if (i % 20 == 0)
      triangles.push_back({first, anywhere(), anywhere()});
    else
      triangles.push_back({first, nearby(), nearby()});
  }
  const auto seen = draw(triangles, four, alongZ({nearest, 0}));
  int sure = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const std::size_t pixel = i / four.size();
    const glm::dvec2 place =
        glm::dvec2(pixel % size, pixel / size) + 0.5 + glm::dvec2(four[i % four.size()]);
    const glm::dvec3 sight(2.0 * place / double{size} - 1.0, 1);
    std::optional<std::size_t> first;
    double z = 1e30;
    double next = 1e30;
    bool isSure = true;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const Meeting meeting = meet(triangles[t], sight);
      if (meeting.z > 0 && std::abs(meeting.inside) < 1e-4) isSure = false;
      if (std::abs(meeting.z / nearest - 1) < 1e-4) isSure = false;
      if (meeting.inside < 0 || meeting.z < nearest || meeting.z >= next) continue;
      next = meeting.z;
      if (next >= z) continue;
      std::swap(z, next);
      first = t;
    }
    if (!isSure || next < z * (1 + 1e-4)) continue;
    ++sure;
    EXPECT_EQ(seen[i], first) << "sample " << i;
  }
  EXPECT_GT(sure, 0.8 * static_cast<double>(seen.size()));
}

TEST_F(RasterTest, OfTrianglesThatLieUponEachOtherTheFirstIsSeen) {
  const std::array<glm::vec3, 3> triangle{{{-3, -3, 1}, {18, -6, 2}, {-9, 27, 3}}};
  for (const auto& seen : draw({triangle, triangle, triangle}, four, alongZ({0.1F, 0})))
    EXPECT_EQ(seen, 0U);
}

}  // namespace
}  // namespace opaline::passes
