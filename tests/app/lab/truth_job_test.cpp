#include "lab/truth_job.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "reference/truth.h"
#include "renderer/shapes.h"

namespace opaline::app {
namespace {

namespace rf = opaline::reference;
using State = TruthJob::State;

/// A marble ball of 10 mm, lit from the side.
Scene litBall() {
  Scene scene = test::sceneOf(test::sphere({0, 0, 0}, 5, 3), test::marble(), {0, 0, 40}, 6);
  scene.lighting.directional.push_back({{0.8F, 0, 0.6F}, {1, 2, 3}});
  return scene;
}

RenderOptions small() {
  RenderOptions options;
  options.width = 24;
  options.height = 16;
  options.antialias = 2;
  return options;
}

TruthOrder integral(double tolerance = 1e-2) {
  TruthOrder order;
  order.method = TruthOrder::Method::Integral;
  order.tolerance = tolerance;
  return order;
}

TruthOrder particles(std::uint64_t count) {
  TruthOrder order;
  order.limits.particles = count;
  return order;
}

void await(const TruthJob& job) {
  while (job.state() == State::Running) std::this_thread::sleep_for(std::chrono::milliseconds(2));
}

std::shared_ptr<const TruthPicture> finished(const Scene& scene, const RenderOptions& options,
                                             const TruthOrder& order,
                                             PositionsByObject positions = {},
                                             const SceneTime& time = {}) {
  const TruthJob job(scene, time, options, order, std::move(positions));
  await(job);
  EXPECT_EQ(job.state(), State::Done) << job.error();
  EXPECT_EQ(job.progress(), 1);
  return job.picture();
}

double meanGreen(const Image& image) {
  double sum = 0;
  for (std::size_t i = 1; i < image.rgba.size(); i += 4) sum += double{image.rgba[i]};
  return sum / (image.width * image.height);
}

/// RMS of the difference relative to the mean of `b`.
double difference(const Image& a, const Image& b) {
  EXPECT_EQ(a.rgba.size(), b.rgba.size());
  double squares = 0;
  double count = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    if (i % 4 == 3) continue;
    squares += std::pow(double{a.rgba[i]} - double{b.rgba[i]}, 2);
    ++count;
  }
  return std::sqrt(squares / count) / meanGreen(b);
}

TEST(TruthJob, IntegralIsThatOfTheReferenceOnAnyThreads) {
  const Scene scene = litBall();
  const rf::Scene still = reference::posedScene(scene, {});
  const rf::Geometry geometry(still);
  const rf::Irradiance irradiance(geometry);
  rf::PictureOptions picture;
  picture.width = 24;
  picture.height = 16;
  picture.antialias = 2;
  const Image expected =
      reference::integralTruth(geometry, irradiance, {Transport::BetterDipole, 1e-2}, picture, {})
          .picture.image;
  RenderOptions options = small();
  options.transport = Transport::BetterDipole;
  for (const int threads : {1, 3}) {
    TruthOrder order = integral();
    order.threads = threads;
    const auto truth = finished(scene, options, order);
    EXPECT_EQ(truth->image.rgba, expected.rgba);
    EXPECT_GT(truth->error, 0);
    EXPECT_LT(truth->error, 1e-2);
  }
}

TEST(TruthJob, ParticlesAreThoseOfTheReference) {
  const Scene scene = litBall();
  const rf::Scene still = reference::posedScene(scene, {});
  const rf::Geometry geometry(still);
  const rf::Irradiance irradiance(geometry);
  rf::PictureOptions picture;
  picture.width = 24;
  picture.height = 16;
  picture.antialias = 2;
  rf::PathTracer tracer(geometry, {});
  tracer.run(5000);
  const Image expected = reference::pathTruth(tracer, geometry, irradiance, picture).image;
  const auto truth = finished(scene, small(), particles(5000));
  EXPECT_EQ(truth->particles, 5000U);
  EXPECT_EQ(truth->image.rgba, expected.rgba);
}

TEST(TruthJob, WithoutALimitItGoesOnUntilTheUsualError) {
  RenderOptions oneBlock = small();
  oneBlock.width = 8;
  oneBlock.height = 8;
  const auto truth = finished(litBall(), oneBlock, {});
  EXPECT_LE(truth->error, 0.02);
  EXPECT_GT(truth->particles, 0U);
}

TEST(TruthJob, PicturesImproveAndThoseHandedOutStay) {
  const TruthJob job(litBall(), {}, small(), particles(100'000));
  std::shared_ptr<const TruthPicture> first;
  double progress = 0;
  while (job.state() == State::Running) {
    if (!first) first = job.picture();
    const double now = job.progress();
    EXPECT_GE(now, 0);
    EXPECT_LE(now, 1);
    progress = std::max(progress, now);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ASSERT_EQ(job.state(), State::Done) << job.error();
  ASSERT_TRUE(first);
  const Image kept = first->image;
  const auto last = job.picture();
  EXPECT_GT(first->error, last->error);
  EXPECT_LT(first->particles, last->particles);
  EXPECT_EQ(first->image.rgba, kept.rgba);
  EXPECT_NEAR(meanGreen(first->image), meanGreen(last->image), 0.1 * meanGreen(last->image));
}

// Either would take days.
TEST(TruthJob, EndsWhenCancelled) {
  RenderOptions large;
  large.width = 2048;
  large.height = 2048;
  TruthOrder endless;
  endless.limits.error = 1e-5;
  for (const TruthOrder& order : {endless, integral(1e-7)}) {
    for (const int milliseconds : {0, 30, 300, 900}) {
      TruthJob job(litBall(), {}, large, order);
      std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
      job.cancel();
      await(job);
      EXPECT_EQ(job.state(), State::Cancelled) << job.error();
      EXPECT_EQ(job.error(), "");
      EXPECT_LT(job.progress(), 1);
    }
  }
}

TEST(TruthJob, MayGoAwayWhileItRuns) {
  RenderOptions large;
  for (const int milliseconds : {0, 50, 200}) {
    const TruthJob job(litBall(), {}, large, integral(1e-7));
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
  }
}

TEST(TruthJob, SaysWhatWentWrong) {
  const auto errorOf = [](const Scene& scene, const RenderOptions& options, const TruthOrder& order,
                          PositionsByObject positions) {
    const TruthJob job(scene, {}, options, order, std::move(positions));
    await(job);
    EXPECT_EQ(job.state(), State::Failed);
    EXPECT_FALSE(job.picture());
    return job.error();
  };
  RenderOptions empty = small();
  empty.width = 0;
  EXPECT_NE(errorOf(litBall(), empty, {}, {}).find("width"), std::string::npos);
  EXPECT_NE(errorOf(litBall(), small(), integral(5), {}).find("tolerance"), std::string::npos);
  EXPECT_NE(errorOf({}, small(), {}, {}), "");
  Scene broken = litBall();
  broken.objects[0].medium.eta = NAN;
  EXPECT_NE(errorOf(broken, small(), {}, {}), "");
  EXPECT_NE(errorOf(litBall(), small(), {}, {{0, {{0, 0, 0}}}}).find("object 0"),
            std::string::npos);
  EXPECT_NE(errorOf(litBall(), small(), {}, {{1, {}}}).find("object 1"), std::string::npos);
}

TEST(TruthJob, WithoutLightThePictureIsBlack) {
  Scene scene = litBall();
  scene.lighting = {};
  const auto truth = finished(scene, small(), {});
  EXPECT_EQ(meanGreen(truth->image), 0);
  EXPECT_EQ(truth->image.pixel(12, 8)[3], 1);
}

// Where the vertices are given to be, and not where the mesh has them: the second of two balls
// moves in front of the first, as it would stand there by itself.
TEST(TruthJob, TakesPositionsFromOutside) {
  const auto two = [](const Vec3& second) {
    Scene scene = litBall();
    scene.objects.push_back({"second", test::sphere(second, 3, 3), test::skin(), {}});
    return scene;
  };
  const Scene apart = two({0, 40, 0});
  const Scene together = two({2, 0, 16});
  const auto expected = finished(together, small(), integral());
  const auto given =
      finished(apart, small(), integral(), {{1, together.objects[1].mesh.positionsMm}});
  // Normals are found anew from the triangles, which differ a little from the sphere's.
  EXPECT_LT(difference(given->image, expected->image), 0.02);
  EXPECT_GT(difference(finished(apart, small(), integral())->image, expected->image), 0.2);
}

TEST(TruthJob, ShowsTheMomentThatIsAskedFor) {
  Scene swinging = litBall();
  swinging.deformers = {{DeformerKind::Squash, 0.4F, 4}};
  Scene still = litBall();
  still.deformers = {{DeformerKind::Squash, 0.4F, 0}};
  const SceneTime quarterOfPeriod{.seconds = 1};
  const auto expected = finished(still, small(), integral());
  const auto found = finished(swinging, small(), integral(), {}, quarterOfPeriod);
  EXPECT_LT(difference(found->image, expected->image), 1e-4);
  EXPECT_GT(difference(finished(swinging, small(), integral())->image, expected->image), 0.1);
}

}  // namespace
}  // namespace opaline::app
