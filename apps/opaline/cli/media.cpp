#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/half_space_option.h"
#include "cli/json.h"
#include "cli/output.h"
#include "opaline/half_space.h"
#include "opaline/media.h"

namespace opaline::app {

namespace {

using Triple = std::array<double, 3>;

std::string cells(const Triple& values, int width, const char* precision) {
  std::string text;
  for (const double value : values) {
    text += fmt::format("{:>{}}", fmt::format(fmt::runtime(precision), value), width);
  }
  return text;
}

std::string row(const Medium& medium, Transport transport, const std::optional<Triple>& published) {
  const MediumLengths lengths = lengthsOf(medium);
  return fmt::format(
      "{:<13}{}{} {:<4}{}{}{}{}\n", medium.name, cells(medium.sigmaSPrimePerMm, 6, "{:.4g}"),
      cells(medium.sigmaAPerMm, 8, "{:.4g}"), fmt::format(" {:g}", medium.eta),
      cells(lengths.meanFreePathMm, 7, "{:.3g}"), cells(lengths.diffusionMm, 7, "{:.3g}"),
      cells(reflectanceWithin(medium, transport), 6, "{:.3f}"),
      published ? cells(*published, 5, "{:.2f}") : "");
}

std::string table(const HalfSpaceOption& halfSpace) {
  std::string text =
      fmt::format("{:<13}{:^18}{:^24}{:<6}{:^21}{:^21}{:^18}{:^15}\n{:<13}", "", "s'", "a", "  eta",
                  "mean free path", "diffusion length", "reflectance", "published", "");
  text += fmt::format("{:^18}{:^24}{:<6}{:^21}{:^21}{:^18}\n", "1/mm", "1/mm", "", "mm", "mm",
                      halfSpace.name());
  text += "measured (Jensen, Marschner, Levoy, Hanrahan 2001, Fig. 5); R G B each\n";
  for (const auto& measured : measuredMedia()) {
    text += row(measured.medium, halfSpace.transport(), measured.diffuseReflectance);
  }
  text += "artistic, never measured\n";
  for (const Medium& medium : artisticMedia()) {
    text += row(medium, halfSpace.transport(), std::nullopt);
  }
  return text;
}

Json json(const HalfSpaceOption& halfSpace) {
  Json list = Json::array();
  const auto add = [&](const Medium& medium, const std::optional<Triple>& published) {
    Json entry = mediumJson(medium);
    entry["measured"] = published.has_value();
    entry["total_reflectance"] = rgbJson(reflectanceWithin(medium, halfSpace.transport()));
    if (published) entry["published_reflectance"] = rgbJson(*published);
    list.push_back(std::move(entry));
  };
  for (const auto& row : measuredMedia()) add(row.medium, row.diffuseReflectance);
  for (const Medium& medium : artisticMedia()) add(medium, std::nullopt);
  Json json;
  halfSpace.describe(json);
  json["media"] = std::move(list);
  return json;
}

}  // namespace

void runMedia(const Arguments& arguments) {
  CommandLine line("media",
                   "Lists all media: reduced scattering s' and absorption a, mean free path z_r = "
                   "1/(s'+a), diffusion length 1/sigma_tr, and total diffuse reflectance of a "
                   "half-space beside the published one. For boundary transport, which depends on "
                   "the body's shape, it is that of better-dipole. In [] is the default.");
  HalfSpaceOption halfSpace;
  bool quiet = false;
  bool asJson = false;
  line.section("Options");
  halfSpace.addTo(line);
  line.outputFlags("one JSON object on standard output", asJson, quiet);
  if (!line.parse(arguments)) return;
  printOut(asJson ? toText(json(halfSpace)) : table(halfSpace));
}

}  // namespace opaline::app
