#pragma once

#include <string>

#include "cli/command_line.h"
#include "cli/json.h"
#include "opaline/render_options.h"

namespace opaline::app {

/// --transport where a half-space is meant. Boundary transport follows the body's own shape and has
/// no half-space; it stands for the better dipole, from which it takes its detail and which open
/// meshes get.
class HalfSpaceOption {
 public:
  void addTo(CommandLine& line);

  Transport transport() const { return transport_; }
  /// The name of the half-space's transport.
  std::string name() const;
  /// The same, with the transport that it stands for if that is another.
  std::string label() const;
  /// Adds `transport` and `half_space`.
  void describe(Json& json) const;

 private:
  Transport transport_ = Transport::Boundary;
};

}  // namespace opaline::app
