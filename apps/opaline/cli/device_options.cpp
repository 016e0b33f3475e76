#include "cli/device_options.h"

#include <sys/resource.h>

#include <algorithm>

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
  addField(line, options::fieldOf<RendererOptions>("memory_limit"), limits);
  line.flag("--validation", "run Vulkan's validation layer, fail on messages", validation);
}

void DeviceOptions::limitHostMemory() const {
  RendererOptions options;
  limits.applyTo(options);
  if (!options.memoryLimit) return;
  rlimit limit{};
  getrlimit(RLIMIT_DATA, &limit);
  limit.rlim_cur = std::min(static_cast<rlim_t>(1e6 * static_cast<double>(*options.memoryLimit)),
                            limit.rlim_max);
  setrlimit(RLIMIT_DATA, &limit);
}

RendererOptions DeviceOptions::rendererOptions(const std::string& otherwise,
                                               const LogCallback& log) const {
  options::NamedSettings chosen{.device = otherwise};
  named.applyTo(chosen);
  RendererOptions options{
      .device = *chosen.device, .validation = validation, .log = log, .rayQueries = rayQueries};
  limits.applyTo(options);
  return options;
}

}  // namespace opaline::app
