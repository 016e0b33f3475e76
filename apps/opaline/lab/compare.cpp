#include <fmt/format.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <utility>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/json.h"
#include "cli/output.h"
#include "cli/paths.h"
#include "cli/picture_options.h"
#include "cli/values.h"
#include "lab/compare_inputs.h"
#include "lab/compare_report.h"
#include "opaline/compare.h"
#include "opaline/error.h"
#include "opaline/file.h"

namespace opaline::app {

namespace {

struct CompareCommand {
  std::filesystem::path a;
  std::filesystem::path b;
  std::optional<std::filesystem::path> mask;
  std::optional<int> block;
  std::optional<double> peak;
  std::optional<double> failAbove;
  CompareTone tone;
  double pixelsPerDegree = compare::usualPixelsPerDegree;
  std::optional<std::filesystem::path> heatmap;
  std::optional<double> heatmapTop;
  bool quiet = false;
  bool json = false;

  void addTo(CommandLine& line) {
    line.requiredPositional("A", "EXR, HDR or PNG", [this](const Given& given) { a = given.text; });
    line.requiredPositional("B", "an image of the same size, to compare A with",
                            [this](const Given& given) { b = given.text; });
    line.section("Figures, over the pixels that both cover (alpha above 0)");
    line.value("--mask", "FILE", "also inside it (above 0.5) and outside",
               [this](const Given& given) { mask = given.text; });
    line.value("--block", "N", "also for the means of NxN blocks, 1 to 16384",
               [this](const Given& given) { block = readInteger(given, 1, 16384); });
    line.value("--peak", "X", "peak of psnr_db [largest value of B; 1 for PNG]",
               [this](const Given& given) {
                 peak = readNumber(given, {0, 1e9, "", true});
               });
    line.value("--fail-above", "X", "exit status 1 if rel_rmse is above X",
               [this](const Given& given) {
                 failAbove = readNumber(given, {0, 1e9});
               });
    line.section("FLIP, of the pictures that render makes, over black");
    line.value("--exposure", "X", "stops, -32 to 32, not for PNG [0]", [this](const Given& given) {
      tone.exposureStops = static_cast<float>(readNumber(given, {-32, 32, "stops"}));
    });
    line.value(
        "--tone", "NAME", "curve: neutral or none, not for PNG [neutral]",
        [this](const Given& given) { tone.curve = readChoice(given, choicesOf<ToneCurve>()); });
    line.value("--pixels-per-degree", "X",
               fmt::format("as the viewer sees them, 1 to 1000 [{:.1f}]", pixelsPerDegree),
               [this](const Given& given) {
                 pixelsPerDegree = readNumber(given, {1, 1000, "pixels"});
               });
    line.section("Output");
    line.value("--heatmap", "FILE.png", "draw |A - B| / mean of B, of pixels or blocks",
               [this](const Given& given) { heatmap = readOutput(given, {".png"}); });
    line.value("--heatmap-max", "X", "its last color, 0.1 is 10 % [above 99 % of pixels]",
               [this](const Given& given) {
                 heatmapTop = readNumber(given, {1e-6, 1e6});
               });
    line.outputFlags("one JSON object on standard output", json, quiet);
  }
};

/// Computes all figures over any selection of pixels.
class Measurement {
 public:
  Measurement(const CompareCommand& command, const ComparedImages& images)
      : images_(images),
        block_(command.block),
        peak_(command.peak),
        flip_(compare::flipMap(images.shownA, images.shownB, command.pixelsPerDegree)) {
    if (!peak_ && images.pictures) peak_ = 1;
  }

  /// None where no pixel is selected.
  std::optional<RegionFigures> over(const compare::Selection& selection) const {
    const auto figures = compare::figuresOver(images_.a, images_.b, selection, peak_);
    if (!figures) return {};
    RegionFigures region{*figures, compare::meanOver(flip_, selection), {}};
    if (block_) {
      region.block = compare::blockFiguresOver(images_.a, images_.b, selection, *block_);
    }
    return region;
  }

 private:
  const ComparedImages& images_;
  std::optional<int> block_;
  std::optional<double> peak_;
  compare::Plane flip_;
};

compare::Selection both(const compare::Selection& a, const compare::Selection& b, bool wantedB) {
  compare::Selection selection(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    selection[i] = a[i] != 0 && (b[i] != 0) == wantedB ? 1 : 0;
  }
  return selection;
}

void writeHeatmap(const CompareCommand& command, const ComparedImages& images,
                  const compare::Selection& selection, CompareReport& report) {
  const compare::Plane errors =
      command.block ? compare::relativeBlockErrors(images.a, images.b, selection, *command.block)
                    : compare::relativeErrors(images.a, images.b, selection);
  report.heatmap = command.heatmap;
  report.heatmapTop = command.heatmapTop.value_or(compare::heatmapTop(errors, selection));
  writePng(*command.heatmap, compare::drawHeatmap(errors, selection, report.heatmapTop));
}

CompareReport measure(const CompareCommand& command) {
  const ComparedImages images = readCompared(command.a, command.b, command.tone);
  std::optional<compare::Selection> mask;
  if (command.mask) mask = readMask(*command.mask, images.a, command.a);

  const compare::Selection common = compare::commonPixels(images.a, images.b);
  if (compare::countOf(common) == 0) {
    throw Error(
        fmt::format("{} and {} have no pixel that both cover, so there is nothing to compare",
                    command.a.string(), command.b.string()));
  }
  const Measurement measurement(command, images);
  CompareReport report;
  report.a = command.a;
  report.b = command.b;
  report.width = images.a.width;
  report.height = images.a.height;
  report.pictures = images.pictures;
  report.whole = measurement.over(common).value();
  if (mask) {
    report.masked = true;
    report.inside = measurement.over(both(common, *mask, true));
    report.outside = measurement.over(both(common, *mask, false));
  }
  if (command.heatmap) writeHeatmap(command, images, common, report);
  return report;
}

}  // namespace

void runCompare(const Arguments& arguments) {
  CommandLine line(
      "compare",
      "Measures how image A differs from image B: root mean square error, 95th percentile, "
      "maximum, PSNR and FLIP, for each channel and in all. In [] is the default.");
  CompareCommand command;
  command.addTo(line);
  if (!line.parse(arguments)) return;
  if (command.heatmapTop && !command.heatmap) {
    throw UsageError("--heatmap-max belongs to --heatmap FILE.png");
  }
  if (command.heatmap) {
    requireWritable(*command.heatmap);
    requireNoInput({{"--heatmap", *command.heatmap}}, {command.a, command.b});
  }

  const CompareReport report = measure(command);
  if (command.heatmap) {
    noteTaker(command.quiet)(
        LogLevel::Note, fmt::format("wrote {}, scale up to {:.4g} %", command.heatmap->string(),
                                    100 * report.heatmapTop));
  }
  printOut(command.json ? toText(toJson(report)) : toReadable(report));
  const double relRmse = report.whole.figures.all.relRmse;
  if (command.failAbove && relRmse > *command.failAbove) {
    throw Error(fmt::format("--fail-above {}: rel_rmse is {:.4g}, which is above",
                            *command.failAbove, relRmse));
  }
}

}  // namespace opaline::app
