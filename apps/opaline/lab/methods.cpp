#include "lab/methods.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "cli/output.h"
#include "cli/picture_options.h"
#include "lab/frame_medians.h"
#include "lab/path_method.h"
#include "opaline/compare.h"
#include "opaline/error.h"
#include "opaline/mesh.h"
#include "reference/integral.h"
#include "reference/path/path_run.h"
#include "reference/picture.h"
#include "reference/posed_scene.h"
#include "reference/truth.h"

namespace opaline::app {

namespace {

namespace rf = opaline::reference;

constexpr int blockEdge = 8;
/// Transports of a half-space, for which the exact integral exists.
constexpr std::array profilesMeasured{Transport::Dipole, Transport::BetterDipole};
constexpr std::array sitesMeasured{Site::Vertex, Site::Fragment};

RenderOptions optionsFor(const MethodsOrder& order, Transport transport, Sum sum, Site site) {
  RenderOptions options;
  options.width = options.height = order.edgePixels;
  options.transport = transport;
  options.sum = sum;
  options.site = site;
  options.antialias = 1;
  return options;
}

rf::PictureOptions pictureOf(const MethodsOrder& order, int every) {
  rf::PictureOptions picture;
  picture.width = picture.height = order.edgePixels;
  picture.aov = Aov::Exitance;
  picture.every = every;
  return picture;
}

/// Exitance by the exact integral, at every `every`-th pixel in each direction.
Image exactExitance(const MethodsOrder& order, const rf::Geometry& geometry, Transport transport,
                    int every) {
  const rf::Irradiance irradiance(geometry);
  return rf::integralTruth(geometry, irradiance, {.transport = transport}, pictureOf(order, every),
                           {})
      .picture.image;
}

std::optional<double> errorAgainst(const Image& found, const Image& exact) {
  const auto figures = compare::figuresOver(found, exact, compare::commonPixels(found, exact));
  return figures ? std::optional(figures->all.relRmse) : std::nullopt;
}

std::optional<double> blockErrorAgainst(const Image& found, const std::optional<Image>& truth) {
  if (!truth) return std::nullopt;
  const auto figures =
      compare::blockFiguresOver(found, *truth, compare::commonPixels(found, *truth), blockEdge);
  return figures ? std::optional(figures->relRmse) : std::nullopt;
}

/// `exact` is nullptr for a transport without an integral.
MethodRow measure(View view, const MethodsOrder& order, const Image* exact,
                  const std::optional<Image>& truth, DeviceDescription& device) {
  const RenderOptions& options = view.options();
  MethodRow row;
  row.transport = options.transport;
  row.sum = options::nameOf(options.sum);
  row.site = options::nameOf(options.site);
  Frame frame;
  for (int i = 0; i <= order.frames; ++i) renderFrame(view, {}, frame);  // the first does not count
  const RenderReport report = view.report();
  row.frameMilliseconds = report.frameMilliseconds;
  device = report.device;
  const std::vector<Image> found = view.render({.aovs = {Aov::Exitance, Aov::Evaluations}}).images;
  if (exact != nullptr) row.integralError = errorAgainst(found[0], *exact);
  row.truthError = blockErrorAgainst(found[0], truth);
  if (options.sum != Sum::Pattern) row.evaluations = compare::meanOverCovered(found[1]);
  return row;
}

bool hasInside(const Scene& scene) {
  const std::vector<BodyFacts> bodies = bodiesOf(scene);
  return std::all_of(bodies.begin(), bodies.end(), [](const BodyFacts& body) {
    return body.surface.trianglesWithoutInside == 0;
  });
}

double meanOfCovered(const Image& image) {
  double sum = 0;
  std::size_t values = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    if (image.rgba[i + 3] <= 0) continue;
    for (std::size_t c = 0; c < 3; ++c) sum += double{image.rgba[i + c]};
    values += 3;
  }
  return values > 0 ? sum / static_cast<double>(values) : 0;
}

/// Exitance of light that is traced through the bodies. The errors of the result go to `methods`.
Image traceTruth(const MethodsOrder& order, const rf::Geometry& geometry, Methods& methods) {
  const rf::Irradiance irradiance(geometry);
  rf::PathTracer tracer(geometry, {});
  const rf::CameraRays rays(geometry.scene().camera, order.edgePixels, order.edgePixels);
  const rf::BlockError error(tracer, geometry, rays, order.edgePixels, order.edgePixels);
  rf::PathLimits limits;
  limits.seconds = order.truthSeconds;
  order.status("following light through the body");
  methods.truthsBlockError = rf::runPaths(tracer, error, limits);
  warnOfLostLight(tracer, geometry.scene(), order.log);
  Image truth = reference::pathTruth(tracer, geometry, irradiance, pictureOf(order, 1)).image;
  if (const double mean = meanOfCovered(truth); mean > 0)
    methods.truthsOwnError = error.ofPicture() / mean;
  return truth;
}

/// The truth that was given, or else one traced here if the scene has an inside.
std::optional<Image> truthFor(const MethodsOrder& order, const rf::Geometry& geometry,
                              Methods& methods) {
  if (order.truth || order.truthSeconds <= 0) return order.truth;
  if (hasInside(order.scene)) return traceTruth(order, geometry, methods);
  order.log(LogLevel::Note,
            "an object is open and has no inside to follow light through, so there is no "
            "comparison with the truth");
  return std::nullopt;
}

/// All pictures of one view must cover the same pixels.
void requireSameView(const Image& truth, const Image& exact) {
  std::size_t covered = 0;
  std::size_t beside = 0;
  for (std::size_t i = 3; i < truth.rgba.size(); i += 4) {
    if (truth.rgba[i] <= 0) continue;
    ++covered;
    if (exact.rgba[i] <= 0) ++beside;
  }
  if (covered == 0 || beside > covered / 100) {
    throw UsageError(
        "--truth shows another picture: render it by reference --path with the same scene and "
        "camera");
  }
}

std::string percent(const std::optional<double>& share) {
  return share ? fmt::format("{:.2f} %", 100 * *share) : "";
}

Json orNull(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

}  // namespace

Methods measureMethods(const MethodsOrder& order) {
  if (order.truth &&
      (order.truth->width != order.edgePixels || order.truth->height != order.edgePixels)) {
    throw UsageError(fmt::format("--truth has {} x {} pixels, but --size is {}", order.truth->width,
                                 order.truth->height, order.edgePixels));
  }
  Renderer renderer({order.device, false, order.log});
  renderer.setScene(order.scene);
  Methods methods;
  methods.scene = order.scene.name;
  methods.edgePixels = order.edgePixels;
  const rf::Scene scene = reference::posedScene(order.scene, {});
  const rf::Geometry geometry(scene);
  const std::optional<Image> truth = truthFor(order, geometry, methods);
  methods.hasTruth = truth.has_value();
  for (const Transport transport : profilesMeasured) {
    const std::string name = options::nameOf(transport);
    order.status(fmt::format("integrating the {}", name));
    const Image exact = exactExitance(order, geometry, transport, order.every);
    if (order.truth) requireSameView(*order.truth, exact);
    for (const Sum sum : {Sum::Pattern, Sum::Tree, Sum::All}) {
      if (sum == Sum::All && !order.all) continue;
      for (const Site site : sitesMeasured) {
        order.status(fmt::format("measuring the {}", name));
        methods.rows.push_back(measure(View(renderer, optionsFor(order, transport, sum, site)),
                                       order, &exact, truth, methods.device));
      }
    }
    MethodRow integral{transport, "integral", "exact", {}, {}, {}, {}};
    integral.truthError = blockErrorAgainst(exact, truth);
    methods.rows.push_back(integral);
  }
  for (const Site site : sitesMeasured) {
    View view(renderer, optionsFor(order, Transport::Boundary, Sum::Tree, site));
    // Without an inside, boundary transport equals the better dipole, which was measured already.
    if (view.render({.aovs = {Aov::Exitance}}).report.clusters == 0) break;
    order.status("measuring boundary transport");
    methods.rows.push_back(measure(std::move(view), order, nullptr, truth, methods.device));
  }
  clearStatus();
  return methods;
}

Json toJson(const Methods& methods) {
  Json rows = Json::array();
  for (const MethodRow& row : methods.rows) {
    rows.push_back({{"transport", options::nameOf(row.transport)},
                    {"sum", row.sum},
                    {"site", row.site},
                    {"frame_ms", orNull(row.frameMilliseconds)},
                    {"evaluations", orNull(row.evaluations)},
                    {"integral_rel_rmse", orNull(row.integralError)},
                    {"truth_block_rel_rmse", orNull(row.truthError)}});
  }
  return {{"scene", methods.scene},
          {"size", {methods.edgePixels, methods.edgePixels}},
          {"device", deviceJson(methods.device)},
          {"truth_block_error", orNull(methods.truthsBlockError)},
          {"truth_own_rel_rmse", orNull(methods.truthsOwnError)},
          {"rows", std::move(rows)}};
}

std::string toReadable(const Methods& methods) {
  std::string text = fmt::format(
      "{0}, exitance at {1}x{1} on {2} ({3})\n"
      "{4:<16}{5:<10}{6:<10}{7:>12}{8:>13}{9:>14}{10:>18}\n",
      methods.scene, methods.edgePixels, methods.device.name, methods.device.type, "transport",
      "sum", "site", "a frame", "evaluations", "to integral",
      methods.hasTruth ? "to truth, blocks" : "");
  for (const MethodRow& row : methods.rows) {
    text += fmt::format(
        "{:<16}{:<10}{:<10}{:>12}{:>13}{:>14}{:>18}\n", options::nameOf(row.transport), row.sum,
        row.site, row.frameMilliseconds ? fmt::format("{:.1f} ms", *row.frameMilliseconds) : "",
        row.evaluations ? fmt::format("{:.1f}", *row.evaluations) : "", percent(row.integralError),
        percent(row.truthError));
  }
  if (methods.truthsOwnError)
    text += fmt::format("the truth's own standard error, in blocks too: {:.2f} %\n",
                        100 * *methods.truthsOwnError);
  return text;
}

}  // namespace opaline::app
