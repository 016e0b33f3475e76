#pragma once

#include <string>

#include "cli/command_line.h"
#include "cli/json.h"
#include "opaline/render_options.h"

namespace opaline::app {

/// --transport where a half-space is spoken of. Boundary transport follows the body's own shape and
/// has none; the better dipole's is what it takes its detail from and what open meshes get.
class HalfSpaceOption {
 public:
  void addTo(CommandLine& line);

  Transport transport() const { return transport_; }
  /// The half-space by its name.
  std::string name() const;
  /// The same, and for which transport it stands if that is another.
  std::string label() const;
  /// Adds `transport` and `half_space`.
  void describe(Json& json) const;

 private:
  Transport transport_ = Transport::Boundary;
};

}  // namespace opaline::app
