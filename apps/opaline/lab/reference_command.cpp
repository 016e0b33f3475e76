#include "lab/reference_command.h"

#include <fmt/format.h>

#include <array>
#include <string>

#include "cli/values.h"
#include "film/frames_asked_for.h"
#include "opaline/error.h"
#include "opaline/options/picture.h"
#include "reference/integral.h"
#include "reference/truth.h"

namespace opaline::app {

namespace rf = opaline::reference;

namespace {

rf::Region readRegion(const Given& given) {
  const auto refuse = [&] {
    throw UsageError(fmt::format("{} {}: must be X,Y,WIDTH,HEIGHT, whole numbers of pixels",
                                 given.option, given.text));
  };
  std::array<int, 4> values{};
  std::size_t begin = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t comma = given.text.find(',', begin);
    if ((comma == std::string::npos) != (i + 1 == values.size())) refuse();
    try {
      values[i] = readInteger({given.option, given.text.substr(begin, comma - begin)}, 0, 16384);
    } catch (const UsageError&) {
      // That message would quote one number as if it were the whole argument.
      refuse();
    }
    begin = comma + 1;
  }
  return {values[0], values[1], values[2], values[3]};
}

}  // namespace

void ReferenceCommand::addTo(CommandLine& line) {
  line.section("Scene");
  scene.addTo(line);
  line.section(LightOptions::section);
  lights.addTo(line);
  line.section("Picture");
  camera.addTo(line);
  picture.addTo(line, false);
  line.value("--region", "X,Y,W,H", "only these pixels, every N-th across and down [1]",
             [this](const Given& given) { region = readRegion(given); });
  line.value("--every", "N", "",
             [this](const Given& given) { every = readInteger(given, 1, 16384); });
  line.section("Motion");
  motion.addTo(line);
  line.flag("--resume", "skip frames that exist and are the same", resume);
  line.section("Method");
  addMethodTo(line);
  line.section("Run");
  line.unavailable("--device", "the reference runs on the CPU; render and view have a device");
  line.value("--report", "FILE.json", "what was done, and how exact it is",
             [this](const Given& given) { report = readOutput(given, {".json"}); });
  line.outputFlags("the report on standard output", json, quiet);
}

void ReferenceCommand::addMethodTo(CommandLine& line) {
  line.flag("--integral", "the exact surface integral of the dipole", integral);
  line.value("--transport", "NAME", "dipole or better-dipole [dipole]",
             [this](const Given& given) { transport = readChoice(given, halfSpaceTransports()); });
  line.value("--tolerance", "X", "relative error allowed, 1e-7 to 0.5 [0.001]",
             [this](const Given& given) {
               tolerance = readNumber(given, {1e-7, 0.5});
             });
  line.flag("--ambient-occlusion", "what hides the sky darkens --aov irradiance", ambientOcclusion);
  path.addTo(line);
}

void ReferenceCommand::check() const {
  if (integral == path.wanted()) {
    throw UsageError("reference needs one method: --integral or --path");
  }
  if (path.wanted() && (transport || tolerance)) {
    throw UsageError("--transport and --tolerance belong to --integral");
  }
  if (ambientOcclusion && (path.wanted() || picture.aov() != Aov::Irradiance)) {
    throw UsageError(
        "--ambient-occlusion needs --integral --aov irradiance: of light that has scattered, only "
        "--path finds it");
  }
  camera.check();
  motion.check();
  picture.requireNameFor(motion.frames().has_value(), resume, motion.chunk().has_value());
  checkVariable();
  static_cast<void>(options({}));
}

void ReferenceCommand::checkVariable() const {
  if (!picture.seenByCamera()) {
    throw UsageError("--aov dsm-*: the reference has no diffusion source map; render shows it");
  }
  if (picture.aov() == Aov::Evaluations) {
    throw UsageError("--aov evaluations: counts the work of render; the reference has none");
  }
  if (picture.aov() == Aov::Surfels) {
    throw UsageError("--aov surfels: the reference works without surfels; render shows them");
  }
  if (picture.asksForReflection() && integral) {
    throw UsageError(
        "--roughness: the integral leaves out reflections; compare it with render --no-specular");
  }
}

RenderOptions ReferenceCommand::options(const SceneFileSettings& settings) const {
  RenderOptions options = optionsOf(settings);
  options.transport = rf::transportOfIntegral(options.transport);
  if (transport) options.transport = *transport;
  picture.applyTo(options);
  return options;
}

rf::PictureOptions ReferenceCommand::pictureOptions(const RenderOptions& render) const {
  rf::PictureOptions options;
  options.width = render.width;
  options.height = render.height;
  options.aov = picture.aov();
  options.antialias = render.antialias;
  options.environmentBehind = render.environmentBehind;
  options.eye = {render.specular, double{render.roughness}};
  options.region = region;
  options.every = every;
  return options;
}

double ReferenceCommand::toleranceOf() const {
  return tolerance.value_or(rf::IntegralOptions{}.tolerance);
}

std::vector<Output> ReferenceCommand::outputs(const Target& output) const {
  std::vector<Output> outputs;
  const auto frames = motion.frames();
  if (output.existing == Existing::Replace) addOutputs("-o", output.path, frames, outputs);
  if (report) outputs.push_back({"--report", *report});
  if (const auto& file = path.checkpoint()) addOutputs("--checkpoint", *file, frames, outputs);
  return outputs;
}

Json ReferenceCommand::describeMethod(const RenderOptions& render) const {
  Json method = integral ? Json{{"method", "integral"},
                                {"transport", options::nameOf(render.transport)},
                                {"tolerance", toleranceOf()},
                                {"ambient_occlusion", ambientOcclusion}}
                         : path.describe();
  if (region) method["region"] = {region->x, region->y, region->width, region->height};
  if (every > 1) method["every"] = every;
  return method;
}

}  // namespace opaline::app
