#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/command_line.h"
#include "opaline/medium.h"
#include "opaline/options/scene.h"
#include "opaline/scene.h"

namespace opaline::app {

/// The media of a scene file, by name.
using OwnMedia = std::map<std::string, Medium, std::less<>>;

/// --medium, for all or for single objects, or else --sigma-s, --sigma-a and --eta; --g goes with
/// either.
class MediumOptions {
 public:
  void addTo(CommandLine& line);
  /// The same where there are no objects.
  void addWithoutObjectsTo(CommandLine& line);
  bool any() const { return named_ || !ofObjects_.empty() || !chosen_.empty(); }
  /// Whether a medium was asked for by its name.
  bool names() const { return named_ || !ofObjects_.empty(); }
  /// The medium that was asked for; none when no such option was given. A name is one of the
  /// scene's own media, or else one of those that `opaline media` lists. Throws UsageError for a
  /// name that is neither, and for a combination that describes no medium.
  std::optional<Medium> medium(const OwnMedia& own = {}) const;
  /// The media of single objects. Throws likewise.
  std::vector<MediumOfObject> ofObjects(const OwnMedia& own) const;

 private:
  /// NAME or NAME@OBJECT as it was typed.
  struct Named {
    Given given;
    std::string medium;
    std::string object;  ///< empty: all
  };

  void read(const Given& given);
  void addCoefficientsTo(CommandLine& line);
  static Medium found(const Named& named, const OwnMedia& own);

  std::optional<Named> named_;
  std::vector<Named> ofObjects_;
  options::Chosen<Medium> chosen_;
};

}  // namespace opaline::app
