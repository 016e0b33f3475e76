#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/half_space_option.h"
#include "cli/json.h"
#include "cli/medium_options.h"
#include "cli/output.h"
#include "cli/paths.h"
#include "cli/values.h"
#include "lab/plot.h"
#include "opaline/error.h"
#include "opaline/file.h"
#include "opaline/half_space.h"
#include "opaline/media.h"

namespace opaline::app {

namespace {

constexpr int plotSamples = 500;

struct ProfileCommand {
  MediumOptions medium;
  HalfSpaceOption halfSpace;
  int samples = 33;
  std::optional<double> mostRadiusMm;
  std::optional<std::filesystem::path> plot;
  bool quiet = false;
  bool json = false;

  void addTo(CommandLine& line) {
    line.section("Medium, marble when none is named");
    medium.addWithoutObjectsTo(line);
    line.section("Options");
    halfSpace.addTo(line);
    line.value("--samples", "N", "radii in the table, 2 to 100000 [33]",
               [this](const Given& given) { samples = readInteger(given, 2, 100000); });
    line.value("--max-radius-mm", "X", "the last radius [5 diffusion lengths]",
               [this](const Given& given) {
                 mostRadiusMm = readNumber(given, {0, 1e6, "mm", true});
               });
    line.value("--plot", "FILE.svg", "plot it, logarithmically",
               [this](const Given& given) { plot = readOutput(given, {".svg"}); });
    line.outputFlags("one JSON object on standard output", json, quiet);
  }
};

/// Five diffusion lengths of the channel with the longest, or 20 mean free paths where there is no
/// absorption.
double defaultRadiusMm(const Medium& medium) {
  const MediumLengths lengths = lengthsOf(medium);
  if (lengths.longestDiffusionMm) return 5 * *lengths.longestDiffusionMm;
  return 20 * *std::max_element(lengths.meanFreePathMm.begin(), lengths.meanFreePathMm.end());
}

ProfileSamples sample(const Medium& medium, Transport transport, double mostRadiusMm, int count) {
  ProfileSamples samples;
  for (int i = 0; i < count; ++i) {
    const double radiusMm = mostRadiusMm * i / (count - 1);
    samples.radiusMm.push_back(radiusMm);
    samples.reflectancePerMm2.push_back(reflectancePerMm2(medium, transport, radiusMm));
  }
  return samples;
}

std::string table(const ProfileSamples& samples, const std::array<double, 3>& total,
                  const std::string& title) {
  std::string text = fmt::format("{}\n{:>12}{:>14}{:>14}{:>14}\n", title, "radius mm",
                                 "R_d red /mm2", "green", "blue");
  for (std::size_t i = 0; i < samples.radiusMm.size(); ++i) {
    const auto& rgb = samples.reflectancePerMm2[i];
    text += fmt::format("{:>12.5g}{:>14.5e}{:>14.5e}{:>14.5e}\n", samples.radiusMm[i], rgb[0],
                        rgb[1], rgb[2]);
  }
  return text +
         fmt::format("{:>12}{:>14.4f}{:>14.4f}{:>14.4f}\n", "total", total[0], total[1], total[2]);
}

Json json(const ProfileSamples& samples, const std::array<double, 3>& total, const Medium& medium,
          const HalfSpaceOption& halfSpace) {
  Json reflectance = Json::array();
  for (const auto& rgb : samples.reflectancePerMm2) reflectance.push_back(rgbJson(rgb));
  Json json{{"medium", mediumJson(medium)}};
  halfSpace.describe(json);
  json["radius_mm"] = samples.radiusMm;
  json["r_d"] = std::move(reflectance);
  json["total_reflectance"] = rgbJson(total);
  return json;
}

}  // namespace

void runProfile(const Arguments& arguments) {
  CommandLine line(
      "profile",
      "Prints the diffuse reflectance R_d(r) of a half-space, per mm^2: light that "
      "leaves at distance r for light that enters in one point, and its integral. For boundary "
      "transport, which depends on the body's shape, it is that of better-dipole. "
      "In [] is the default.");
  ProfileCommand command;
  command.addTo(line);
  if (!line.parse(arguments)) return;

  const Medium medium = command.medium.medium().value_or(*findMedium("marble"));
  const std::string title = fmt::format("{}, {}", medium.name, command.halfSpace.label());
  const Transport transport = command.halfSpace.transport();
  const std::array<double, 3> total = reflectanceWithin(medium, transport);
  if (command.plot) requireWritable(*command.plot);
  const double mostRadiusMm = command.mostRadiusMm.value_or(defaultRadiusMm(medium));
  if (command.plot) {
    writeWhole(*command.plot, plotSvg(sample(medium, transport, mostRadiusMm, plotSamples), title));
    noteTaker(command.quiet)(LogLevel::Note, fmt::format("wrote {}", command.plot->string()));
  }
  const ProfileSamples samples = sample(medium, transport, mostRadiusMm, command.samples);
  printOut(command.json ? toText(json(samples, total, medium, command.halfSpace))
                        : table(samples, total, title));
}

}  // namespace opaline::app
