#pragma once

#include <optional>
#include <string>

#include "opaline/log.h"
#include "opaline/options/picture.h"
#include "opaline/renderer.h"

namespace opaline::app {

class CommandLine;

/// Which device renders, and how: what render and view share of their section "Run".
struct DeviceOptions {
  options::Chosen<options::NamedSettings> named;
  options::Chosen<RendererOptions> limits;
  std::optional<bool> rayQueries;
  bool validation = false;

  void addTo(CommandLine& line);
  /// Keeps what this process takes of the host's memory below --memory-limit, where there is one.
  void limitHostMemory() const;
  /// `otherwise` where no device was asked for.
  RendererOptions rendererOptions(const std::string& otherwise, const LogCallback& log) const;
};

}  // namespace opaline::app
