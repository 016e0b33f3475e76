#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>

#include "bssrdf/media.h"
#include "bssrdf/profile.h"
#include "command_line.h"
#include "commands.h"
#include "json.h"
#include "medium_options.h"
#include "output.h"

namespace opaline::app {

namespace {

using Triple = std::array<double, 3>;

Triple reflectance(const Medium& medium) {
  Triple total{};
  for (int channel = 0; channel < 3; ++channel) {
    total[static_cast<std::size_t>(channel)] =
        makeProfile(bssrdf::Model::Dipole, bssrdf::coefficients(medium, channel))
            .totalReflectance();
  }
  return total;
}

std::string cells(const Triple& values, int width, const char* precision) {
  std::string text;
  for (const double value : values) {
    text += fmt::format("{:>{}}", fmt::format(fmt::runtime(precision), value), width);
  }
  return text;
}

std::string row(const Medium& medium, const std::optional<Triple>& published) {
  const MediumLengths lengths = lengthsOf(medium);
  return fmt::format(
      "{:<13}{}{} {:<4}{}{}{}{}\n", medium.name, cells(medium.sigmaSPrimePerMm, 6, "{:.4g}"),
      cells(medium.sigmaAPerMm, 8, "{:.4g}"), fmt::format(" {:g}", medium.eta),
      cells(lengths.meanFreePathMm, 7, "{:.3g}"), cells(lengths.diffusionMm, 7, "{:.3g}"),
      cells(reflectance(medium), 6, "{:.3f}"), published ? cells(*published, 5, "{:.2f}") : "");
}

std::string table() {
  std::string text =
      fmt::format("{:<13}{:^18}{:^24}{:<6}{:^21}{:^21}{:^18}{:^15}\n{:<13}", "", "s'", "a", "  eta",
                  "mean free path", "diffusion length", "reflectance", "published", "");
  text += fmt::format("{:^18}{:^24}{:<6}{:^21}{:^21}\n", "1/mm", "1/mm", "", "mm", "mm");
  text += "measured (Jensen, Marschner, Levoy, Hanrahan 2001, Fig. 5); R G B each\n";
  for (const auto& measured : bssrdf::measuredMedia()) {
    text += row(measured.medium, measured.diffuseReflectance);
  }
  text += "artistic, never measured\n";
  for (const Medium& medium : bssrdf::artisticMedia()) text += row(medium, std::nullopt);
  return text;
}

Json json() {
  Json list = Json::array();
  const auto add = [&list](const Medium& medium, const std::optional<Triple>& published) {
    Json entry = mediumJson(medium);
    entry["measured"] = published.has_value();
    entry["total_reflectance"] = rgbJson(reflectance(medium));
    if (published) entry["published_reflectance"] = rgbJson(*published);
    list.push_back(std::move(entry));
  };
  for (const auto& row : bssrdf::measuredMedia()) add(row.medium, row.diffuseReflectance);
  for (const Medium& medium : bssrdf::artisticMedia()) add(medium, std::nullopt);
  return {{"media", std::move(list)}};
}

}  // namespace

void runMedia(const Arguments& arguments) {
  CommandLine line("media",
                   "Lists all media: reduced scattering s' and absorption a, mean free path z_r = "
                   "1/(s'+a), diffusion length 1/sigma_tr, and total diffuse reflectance by the "
                   "dipole of Jensen et al. 2001, beside the published one.");
  bool asJson = false;
  line.section("Options");
  line.flag("--json", "one JSON object on standard output", asJson);
  if (!line.parse(arguments)) return;
  printOut(asJson ? toText(json()) : table());
}

}  // namespace opaline::app
