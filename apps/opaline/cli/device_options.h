#pragma once

#include <optional>
#include <string>

#include "opaline/log.h"
#include "opaline/options/picture.h"
#include "opaline/renderer.h"

namespace opaline::app {

class CommandLine;

/// Which device renders, and how: the options of the section "Run" that render and view share.
struct DeviceOptions {
  options::Chosen<options::NamedSettings> named;
  options::Chosen<RendererOptions> limits;
  std::optional<bool> rayQueries;
  bool validation = false;

  void addTo(CommandLine& line);
  /// Keeps this process's host memory below --memory-limit, where that is given.
  void limitHostMemory() const;
  /// Uses `otherwise` where no device was asked for.
  RendererOptions rendererOptions(const std::string& otherwise, const LogCallback& log) const;
};

}  // namespace opaline::app
