#include "cli/device_options.h"

#include "cli/command_line.h"
#include "cli/fields.h"
#include "cli/values.h"

namespace opaline::app {

namespace {

const Choices<std::optional<bool>>& rayQueryChoices() {
  static const Choices<std::optional<bool>> table{
      {"auto", std::nullopt}, {"on", true}, {"off", false}};
  return table;
}

}  // namespace

void DeviceOptions::addTo(CommandLine& line) {
  addField(line, options::fieldOf<options::NamedSettings>("device"), named);
  line.value("--ray-queries", "WHEN", "rays by VK_KHR_ray_query: on, off or auto [auto]",
             [this](const Given& given) { rayQueries = readChoice(given, rayQueryChoices()); });
  line.flag("--validation", "run Vulkan's validation layer, fail on messages", validation);
}

RendererOptions DeviceOptions::rendererOptions(const std::string& otherwise,
                                               const LogCallback& log) const {
  options::NamedSettings chosen{.device = otherwise};
  named.applyTo(chosen);
  return {.device = *chosen.device, .validation = validation, .log = log, .rayQueries = rayQueries};
}

}  // namespace opaline::app
