#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/command_line.h"
#include "opaline/medium.h"
#include "opaline/options/scene.h"
#include "opaline/scene.h"

namespace opaline::app {

/// --medium, for all or for single objects, or else --sigma-s, --sigma-a and --eta; --g goes with
/// either.
class MediumOptions {
 public:
  void addTo(CommandLine& line);
  /// The same where there are no objects.
  void addWithoutObjectsTo(CommandLine& line);
  bool any() const { return named_ || !ofObjects_.empty() || !chosen_.empty(); }
  /// The medium that was asked for; none when no such option was given. Throws UsageError for a
  /// combination that describes no medium.
  std::optional<Medium> medium() const;
  /// The media of single objects.
  const std::vector<MediumOfObject>& ofObjects() const { return ofObjects_; }

 private:
  void read(const Given& given);
  void addCoefficientsTo(CommandLine& line);

  std::optional<Medium> named_;
  std::vector<MediumOfObject> ofObjects_;
  options::Chosen<Medium> chosen_;
};

}  // namespace opaline::app
