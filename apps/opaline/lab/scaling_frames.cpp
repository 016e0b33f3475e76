#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

#include "lab/frame_medians.h"
#include "lab/scaling.h"
#include "lab/scaling_scenes.h"

namespace opaline::app {

namespace {

constexpr double filmFramesPerSecond = 30;
constexpr std::array surfelParts{16, 4, 1};
constexpr std::array clusterParts{64, 16, 4, 1};
constexpr std::array lightsMeasured{1, 2, 4, 8, 16};
constexpr std::array edgeParts{4, 2, 1};

/// Surfels per cluster at the largest number of clusters.
constexpr int surfelsOfCluster = 16;
constexpr int fewestClusters = 64;
/// A medium that asks for this many surfels also asks for one cluster.
constexpr int surfelsAskedWithCluster = 160;

using Names = std::initializer_list<std::string_view>;

/// A row while it is measured.
struct FrameWay {
  std::shared_ptr<Renderer> renderer;
  View view;
  double value = 0;
  FrameMedians medians;
};

class FrameMeasurement {
 public:
  FrameMeasurement(const ScalingOrder& order, const char* varied)
      : order_(order), series_{.varied = varied, .rows = {}} {}

  /// The program's default options, with light at vertices.
  RenderOptions options() const {
    RenderOptions options;
    options.width = options.height = order_.edgePixels;
    options.site = Site::Vertex;
    return options;
  }

  std::shared_ptr<Renderer> rendererFor(const Scene& scene) const {
    // No log: budgets are meant to bind.
    auto renderer = std::make_shared<Renderer>(RendererOptions{.device = order_.device, .log = {}});
    renderer->setScene(scene);
    return renderer;
  }

  View& add(std::shared_ptr<Renderer> renderer, const RenderOptions& options) {
    View view(*renderer, options);
    ways_.push_back({std::move(renderer), std::move(view), 0, {}});
    return ways_.back().view;
  }

  /// Renders one frame of each way in turn, again and again, so that other load on the machine
  /// affects all alike.
  FrameScaling measure(Names passes, auto valueOf) {
    Frame done;
    for (int frame = 0; frame <= order_.frames; ++frame) {
      order_.status("measuring frames by " + series_.varied);
      for (FrameWay& way : ways_) {
        way.renderer->setTime({.seconds = frame / filmFramesPerSecond});
        renderFrame(way.view, {}, done);
        way.medians.add(done);
      }
    }
    for (const FrameWay& way : ways_)
      series_.rows.push_back({static_cast<double>(valueOf(way.view)),
                              way.medians.passMilliseconds(passes),
                              way.medians.frameMilliseconds()});
    series_.partExponent = fittedExponent(series_.rows, &FrameScalingRow::partMilliseconds);
    series_.frameExponent = fittedExponent(series_.rows, &FrameScalingRow::frameMilliseconds);
    return std::move(series_);
  }

 private:
  const ScalingOrder& order_;
  FrameScaling series_;
  std::vector<FrameWay> ways_;
};

FrameScaling measureSurfels(const ScalingOrder& order) {
  FrameMeasurement measurement(order, "surfels");
  const double denserBy = densityFor(order.scene, order.mostSurfels);
  const auto renderer = measurement.rendererFor(withDenserMedia(order.scene, denserBy));
  for (const int part : surfelParts) {
    RenderOptions options = measurement.options();
    options.maxSurfels = order.mostSurfels / part;
    measurement.add(renderer, options);
  }
  return measurement.measure({"gather", "rays", "clusters", "sky", "tree"},
                             [](const View& view) { return view.report().sources; });
}

bool hasClusters(View& view) {
  Frame done;
  renderFrame(view, {}, done);
  return view.report().clusters > 0;
}

std::optional<FrameScaling> measureClusters(const ScalingOrder& order) {
  FrameMeasurement measurement(order, "clusters");
  const int mostClusters = order.mostSurfels / surfelsOfCluster;
  const double denserBy = densityFor(order.scene, surfelsAskedWithCluster * mostClusters);
  const auto renderer = measurement.rendererFor(withDenserMedia(order.scene, denserBy));
  for (const int part : clusterParts) {
    RenderOptions options = measurement.options();
    options.maxSurfels = order.mostSurfels;
    options.maxClusters = std::max(mostClusters / part, fewestClusters);
    View& view = measurement.add(renderer, options);
    if (part == clusterParts.front() && !hasClusters(view)) return std::nullopt;
  }
  return measurement.measure({"clusters", "rays", "coefficients", "sources", "solve", "carry"},
                             [](const View& view) { return view.report().clusters; });
}

// Puts lights around the body whose power adds up to the same total.
Scene withLights(Scene scene, int count) {
  Lighting lighting;
  lighting.ambient = scene.lighting.ambient;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.5) / count;
    const auto share = static_cast<float>(std::numbers::pi / count);
    lighting.directional.push_back(
        {{static_cast<float>(std::cos(angle)), 0, static_cast<float>(std::sin(angle))},
         {share, share, share}});
  }
  scene.lighting = std::move(lighting);
  return scene;
}

FrameScaling measureLights(const ScalingOrder& order) {
  FrameMeasurement measurement(order, "lights");
  for (const int lights : lightsMeasured)
    measurement.add(measurement.rendererFor(withLights(order.scene, lights)),
                    measurement.options());
  std::size_t next = 0;
  return measurement.measure({"shadow", "gather", "clusters", "rays", "sources"},
                             [&](const View&) { return lightsMeasured.at(next++); });
}

FrameScaling measurePixels(const ScalingOrder& order) {
  FrameMeasurement measurement(order, "pixels");
  const auto renderer = measurement.rendererFor(order.scene);
  for (const int part : edgeParts) {
    RenderOptions options = measurement.options();
    options.width = options.height = std::max(2 * order.edgePixels / part, 1);
    measurement.add(renderer, options);
  }
  return measurement.measure({"surface", "reflected sky", "shade"}, [](const View& view) {
    return view.options().width * view.options().height;
  });
}

}  // namespace

std::optional<double> fittedExponent(const std::vector<FrameScalingRow>& rows,
                                     double FrameScalingRow::*time) {
  double values = 0;
  double times = 0;
  for (const FrameScalingRow& row : rows) {
    if (!(row.value > 0 && row.*time > 0)) return std::nullopt;
    values += std::log(row.value) / static_cast<double>(rows.size());
    times += std::log(row.*time) / static_cast<double>(rows.size());
  }
  double both = 0;
  double square = 0;
  for (const FrameScalingRow& row : rows) {
    const double away = std::log(row.value) - values;
    both += away * (std::log(row.*time) - times);
    square += away * away;
  }
  return square > 0 ? std::optional(both / square) : std::nullopt;
}

std::vector<FrameScaling> measureFrames(const ScalingOrder& order) {
  std::vector<FrameScaling> frames{measureSurfels(order)};
  if (auto clusters = measureClusters(order)) frames.push_back(std::move(*clusters));
  frames.push_back(measureLights(order));
  frames.push_back(measurePixels(order));
  return frames;
}

}  // namespace opaline::app
