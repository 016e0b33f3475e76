#include "lab/scaling.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "cli/output.h"
#include "lab/frame_medians.h"
#include "lab/scaling_scenes.h"
#include "opaline/compare.h"

namespace opaline::app {

namespace {

constexpr double framesPerSecond = 30;
constexpr std::array budgetParts{16, 4, 1};
constexpr std::array sigmaTrDivisors{1.0, 10.0, 100.0};
constexpr std::array tolerancesMeasured{0.1, 0.03, 0.01, 0.003};
/// The smallest tolerance that is allowed.
constexpr double finestTolerance = 1e-4;

using SharedRenderer = std::shared_ptr<Renderer>;

/// A row while it is measured.
struct ScalingWay {
  ScalingRow row;
  SharedRenderer renderer;
  View view;
  FrameMedians medians;

  void change(auto RenderOptions::*option, auto value) {
    RenderOptions options = view.options();
    options.*option = value;
    view.setOptions(options);
  }
};

RenderOptions optionsFor(const ScalingOrder& order) {
  RenderOptions options;
  options.width = options.height = order.edgePixels;
  options.transport = Transport::Dipole;
  options.sum = Sum::Tree;
  options.site = Site::Fragment;
  options.antialias = 1;
  return options;
}

SharedRenderer rendererFor(const ScalingOrder& order, const Scene& scene, const LogCallback& log) {
  auto renderer = std::make_shared<Renderer>(RendererOptions{.device = order.device, .log = log});
  renderer->setScene(scene);
  return renderer;
}

ScalingWay makeWay(const ScalingOrder& order, double value, const Scene& scene,
                   SharedRenderer renderer) {
  ScalingRow row;
  row.value = value;
  row.medium = scene.objects.at(0).medium;
  View view(*renderer, optionsFor(order));
  return {std::move(row), std::move(renderer), std::move(view), {}};
}

/// Renders one frame of each way in turn, again and again, so that other load on the machine
/// affects all alike.
void measureInTurns(std::vector<ScalingWay>& ways, const ScalingOrder& order, const char* status) {
  Frame done;
  for (int frame = 0; frame <= order.frames; ++frame) {
    order.status(status);
    for (ScalingWay& way : ways) {
      way.renderer->setTime({.seconds = frame / framesPerSecond});
      renderFrame(way.view, {}, done);
      way.medians.add(done);
    }
  }
  for (ScalingWay& way : ways) {
    way.renderer->setTime({});
    renderFrame(way.view, {.aovs = {Aov::Evaluations}}, done);
    way.row.evaluations = compare::meanOverCovered(done.images[0]);
    way.row.surfels = way.view.report().sources;
    way.row.gatherMilliseconds = way.medians.passMilliseconds({"gather", "tree"});
    way.row.scatterMilliseconds = way.medians.passMilliseconds({"estimate", "scatter"});
    way.row.nearbyMilliseconds = way.medians.passMilliseconds({"nearby"});
    way.row.frameMilliseconds = way.medians.frameMilliseconds();
  }
}

std::vector<ScalingRow> rowsOf(const std::vector<ScalingWay>& ways) {
  std::vector<ScalingRow> rows;
  rows.reserve(ways.size());
  for (const ScalingWay& way : ways) rows.push_back(way.row);
  return rows;
}

std::vector<ScalingRow> measureBudgets(const ScalingOrder& order, double denserBy) {
  const Scene scene = withDenserMedia(order.scene, denserBy);
  std::vector<ScalingWay> ways;
  for (const int part : budgetParts) {
    const int budget = order.mostSurfels / part;
    // No log: the budget is meant to bind.
    ways.push_back(makeWay(order, budget, scene, rendererFor(order, scene, {})));
    ways.back().change(&RenderOptions::maxSurfels, budget);
  }
  measureInTurns(ways, order, "measuring budgets of surfels");
  return rowsOf(ways);
}

std::vector<ScalingRow> measureDiffusion(const ScalingOrder& order) {
  std::vector<ScalingWay> ways;
  for (const double divisor : sigmaTrDivisors) {
    const Scene scene = withSmallerSigmaTr(order.scene, divisor);
    const LogCallback log = ways.empty() ? order.log : LogCallback{};  // notes once
    ways.push_back(makeWay(order, divisor, scene, rendererFor(order, scene, log)));
  }
  measureInTurns(ways, order, "measuring longer paths of light");
  return rowsOf(ways);
}

Image exitanceOf(View& view) {
  return std::move(view.render({.aovs = {Aov::Exitance}}).images[0]);
}

std::vector<ScalingRow> measureTolerances(const ScalingOrder& order, DeviceDescription& device) {
  const SharedRenderer renderer = rendererFor(order, order.scene, {});
  std::vector<ScalingWay> ways;
  for (const double tolerance : tolerancesMeasured) {
    ways.push_back(makeWay(order, tolerance, order.scene, renderer));
    ways.back().change(&RenderOptions::tolerance, static_cast<float>(tolerance));
  }
  measureInTurns(ways, order, "measuring tolerances");
  RenderOptions options = optionsFor(order);
  options.tolerance = static_cast<float>(finestTolerance);
  View finestView(*renderer, options);
  const Image finest = exitanceOf(finestView);
  for (ScalingWay& way : ways) {
    const Image found = exitanceOf(way.view);
    const auto figures = compare::figuresOver(found, finest, compare::commonPixels(found, finest));
    if (figures) way.row.error = figures->all.relRmse;
  }
  device = finestView.report().device;
  return rowsOf(ways);
}

}  // namespace

Scaling measureScaling(const ScalingOrder& order) {
  Scaling scaling;
  scaling.scene = order.scene.name;
  scaling.edgePixels = order.edgePixels;
  scaling.denserBy = densityFor(order.scene, order.mostSurfels);
  scaling.finestTolerance = finestTolerance;
  scaling.diffusion = measureDiffusion(order);
  scaling.tolerances = measureTolerances(order, scaling.device);
  scaling.budgets = measureBudgets(order, scaling.denserBy);
  scaling.frames = measureFrames(order);
  scaling.hasInside = std::ranges::any_of(
      scaling.frames, [](const FrameScaling& series) { return series.varied == "clusters"; });
  clearStatus();
  return scaling;
}

}  // namespace opaline::app
