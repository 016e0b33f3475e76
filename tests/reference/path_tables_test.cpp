// Volumetric light transport against tables made by another program, and against exact transfer.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "bssrdf/fresnel.h"
#include "bssrdf/half_space.h"
#include "reference/path/layer.h"
#include "reference/path/path_tracer.h"
#include "reference/path_fixture.h"
#include "shared_files.h"
#include "table.h"

namespace opaline::reference {
namespace {

using std::numbers::pi;
using test::number;
using test::referenceTable;
using test::Row;
using test::rowsOf;

int particlesOfTests() {
  const char* wanted = std::getenv("OPALINE_PATH_PARTICLES");  // for manual runs
  return wanted == nullptr ? 4000 : std::atoi(wanted);
}

/// Empty if the tables are not available.
std::vector<Row> readTable(const std::string& name) {
  return rowsOf(referenceTable(name).value_or(""));
}

/// How many comparisons were beyond three standard errors.
struct Outcome {
  int entries = 0;
  int far = 0;

  void compare(double found, double foundError, double expected, double expectedError) {
    ++entries;
    // A count of zero still has the error of one.
    if (std::abs(found - expected) > 3 * std::hypot(foundError, expectedError)) ++far;
  }
};

/// Shares of particles by side and order.
struct SlabShares {
  double reflected[3] = {};
  double transmitted[3] = {};
};

SlabShares traceSlab(double thickness, double reach, const Interior& interior, bool diffuse,
                     int particles) {
  const auto half = static_cast<float>(reach);
  const auto deep = static_cast<float>(thickness / 2);
  const Scene scene = sceneOf(bodyOf(test::box({0, 0, 0}, {half, half, deep}, 1),
                                     interior.sigmaTPerMm * interior.albedo,
                                     interior.sigmaTPerMm * (1 - interior.albedo), interior.eta));
  const Geometry geometry(scene);
  const DistanceBound bound(scene);
  const std::vector<Interior> interiors{interior};
  const Walk walk(geometry, bound, interiors, 0);
  SlabShares shares;
  for (int i = 0; i < particles; ++i) {
    Random random(7, static_cast<std::uint64_t>(i));
    const double cosine = diffuse ? std::sqrt(random()) : 1;
    const double angle = 2 * pi * random();
    const double sine = std::sqrt(1 - cosine * cosine);
    const Vector direction{sine * std::cos(angle), sine * std::sin(angle), -cosine};
    // Aims off the diagonal along which the side is cut into two triangles.
    const Vector target{0.31 * interior.eta, 0.17, thickness / 2};
    walk.follow({target - 1.0 * direction, direction}, random, [&](const Leaving& leaving) {
      double* side = leaving.point.position[2] > 0 ? shares.reflected : shares.transmitted;
      side[static_cast<int>(leaving.order)] += 1.0 / particles;
    });
  }
  return shares;
}

double errorOf(double share, int particles) {
  return std::sqrt(std::max(share * (1 - share), 1.0 / particles) / particles);
}

TEST(PathTest, SlabsAreThoseOfTheTable) {
  const auto table = readTable("slab_mc.csv");
  if (table.empty()) GTEST_SKIP() << "the reference tables are not there";
  const int particles = particlesOfTests();
  Outcome outcome;
  for (const auto& row : table) {
    const double s = number(row, "sigma_s_per_mm");
    const double a = number(row, "sigma_a_per_mm");
    const Interior interior{s + a, s / (s + a), 0, number(row, "eta")};
    const double diffusion = 1 / std::sqrt(3 * a * (a + s));
    const bool endless = row.at("thickness_mm") == "inf";
    const double thickness = endless ? 12 * diffusion : number(row, "thickness_mm");
    const SlabShares shares =
        traceSlab(thickness, 20 * diffusion, interior, row.at("light") == "diffuse", particles);
    const auto compare = [&](const std::string& side, const double* found) {
      outcome.compare(found[1], errorOf(found[1], particles), number(row, side + "_single"),
                      number(row, side + "_single_err"));
      outcome.compare(found[2], errorOf(found[2], particles), number(row, side + "_multiple"),
                      number(row, side + "_multiple_err"));
    };
    compare("reflected", shares.reflected);
    if (!endless) compare("transmitted", shares.transmitted);
  }
  RecordProperty("entries", outcome.entries);
  RecordProperty("far", outcome.far);
  EXPECT_LE(outcome.far, outcome.entries / 20) << outcome.entries << " entries";
}

// Exact by Chandrasekhar's H for a half-space.
TEST(PathTest, LayersTakeWhatExactTransferSays) {
  const int particles = particlesOfTests();
  Outcome outcome;
  for (const double thickness : {0.1, 0.4}) {
    Interior interior{1, 0.95, 0, 1.4};
    interior.layer = std::make_shared<const Layer>(thickness);
    const test::HalfSpace exact(0.95, 1.4);
    for (const bool diffuse : {false, true}) {
      const SlabShares shares = traceSlab(40, 60, interior, diffuse, particles);
      const double found = shares.reflected[1] + shares.reflected[2];
      const double entered =
          diffuse ? bssrdf::meanTransmittance(1.4) : 1 - bssrdf::fresnelReflectance(1.4, 1);
      const double expected =
          entered * (diffuse ? exact.ofEvenLight(thickness) : exact.ofBeam(thickness, 1));
      outcome.compare(found, errorOf(found, particles), expected, 0);
    }
  }
  EXPECT_EQ(outcome.far, 0) << outcome.entries << " entries";
}

TEST(PathTest, SpheresAreThoseOfTheTable) {
  const auto table = readTable("sphere_exitance_mc.csv");
  if (table.empty()) GTEST_SKIP() << "the reference tables are not there";
  const int particles = 5 * particlesOfTests();
  constexpr int bands = 20;
  Outcome outcome;
  for (std::size_t first = 0; first + bands <= table.size(); first += bands) {
    const auto& head = table[first];
    const double s = number(head, "sigma_s_per_mm");
    const double a = number(head, "sigma_a_per_mm");
    const double radius = number(head, "radius_mm");
    Scene scene = sceneOf(
        bodyOf(test::sphere({0, 0, 0}, static_cast<float>(radius), 6), s, a, number(head, "eta")));
    scene.lighting.directional = {{{0, 0, 1}, {1, 1, 1}}};
    const Geometry geometry(scene);
    const DistanceBound bound(scene);
    const std::vector<Interior> interiors{{s + a, s / (s + a), 0, number(head, "eta")}};
    const Walk walk(geometry, bound, interiors, 0);
    const Emitter emitter(geometry, 0);
    std::vector<double> single(bands);
    std::vector<double> multiple(bands);
    const double perCount = emitter.flux() / particles / (4 * pi * radius * radius / bands);
    for (int i = 0; i < particles; ++i) {
      Random random(11, static_cast<std::uint64_t>(i));
      walk.follow(emitter.emit(random), random, [&](const Leaving& leaving) {
        const Vector& position = leaving.point.position;
        const double cosine = position[2] / length(position);
        const auto band =
            static_cast<std::size_t>(std::clamp((cosine + 1) / 2 * bands, 0.0, bands - 1.0));
        if (leaving.order == Order::Single) single[band] += 1;
        if (leaving.order == Order::Multiple) multiple[band] += 1;
      });
    }
    for (std::size_t band = 0; band < bands; ++band) {
      const auto& row = table[first + band];
      const auto compare = [&](double count, const std::string& column) {
        outcome.compare(count * perCount, std::sqrt(std::max(count, 1.0)) * perCount,
                        number(row, column), number(row, column + "_err"));
      };
      compare(single[band], "exitance_single");
      compare(multiple[band], "exitance_multiple");
    }
  }
  RecordProperty("entries", outcome.entries);
  RecordProperty("far", outcome.far);
  EXPECT_LE(outcome.far, outcome.entries / 20) << outcome.entries << " entries";
}

}  // namespace
}  // namespace opaline::reference
