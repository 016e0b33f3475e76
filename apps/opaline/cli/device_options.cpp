#include "cli/device_options.h"

#include "cli/command_line.h"
#include "cli/values.h"
#include "opaline/error.h"

namespace opaline::app {

namespace {

const Choices<std::optional<bool>>& rayQueryChoices() {
  static const Choices<std::optional<bool>> table{
      {"auto", std::nullopt}, {"on", true}, {"off", false}};
  return table;
}

}  // namespace

void DeviceOptions::addTo(CommandLine& line) {
  line.value("--device", "NAME|INDEX", "as opaline info lists them [the best]",
             [this](const Given& given) {
               if (given.text.empty()) throw UsageError("--device needs a value, NAME|INDEX");
               device = given.text;
             });
  line.value("--ray-queries", "WHEN", "rays by VK_KHR_ray_query: on, off or auto [auto]",
             [this](const Given& given) { rayQueries = readChoice(given, rayQueryChoices()); });
  line.flag("--validation", "run Vulkan's validation layer, fail on messages", validation);
}

RendererOptions DeviceOptions::rendererOptions(const std::string& otherwise,
                                               const LogCallback& log) const {
  return {.device = device.value_or(otherwise),
          .validation = validation,
          .log = log,
          .rayQueries = rayQueries};
}

}  // namespace opaline::app
