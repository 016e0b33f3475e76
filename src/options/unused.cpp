#include <array>

#include "opaline/options/picture.h"

namespace opaline::options {

namespace {

/// A sentence is written with options as an interface spells them.
class Words {
 public:
  explicit Words(Spelling spelling) : spelling_(spelling) {}
  std::string operator()(std::string_view key, const Value& value) const {
    return spelling_(fieldOf<PictureSettings>(key), value);
  }
  template <typename Enumeration>
  requires std::is_enum_v<Enumeration> std::string operator()(std::string_view key,
                                                              Enumeration value) const {
    return (*this)(key, Value{nameOf(value)});
  }

 private:
  Spelling spelling_;
};

struct Rule {
  std::string_view key;
  bool (*isUnused)(const RenderOptions& options);
  std::string (*why)(const Words& words);
};

bool hasNoPattern(const RenderOptions& options) {
  return options.sum != Sum::Pattern;
}

std::string shapesThePattern(const Words& words) {
  return "shapes the pattern and needs " + words("sum", Sum::Pattern);
}

bool cannotSum(const RenderOptions& options) {
  return options.transport == Transport::Boundary && options.sum == Sum::Pattern;
}

std::string needsAnotherTransport(const Words& words) {
  return "and needs " + words("transport", Transport::Dipole) + " or " +
         words("transport", Transport::BetterDipole);
}

std::string needsSurfels(const Words& words) {
  return "and needs " + words("sum", Sum::Tree) + " or " + words("sum", Sum::All);
}

constexpr std::array rules{
    Rule{"transport", cannotSum,
         [](const Words& words) { return "works with surfels " + needsSurfels(words); }},
    Rule{"sum", cannotSum,
         [](const Words& words) {
           return "has no surfels for boundary transport " + needsAnotherTransport(words);
         }},
    Rule{"near_rings", hasNoPattern, shapesThePattern},
    Rule{"near_spacing", hasNoPattern, shapesThePattern},
    Rule{"far_distance", hasNoPattern, shapesThePattern},
    Rule{"tolerance",
         [](const RenderOptions& options) {
           return options.sum != Sum::Tree && options.transport != Transport::Boundary &&
                  !options.ambientOcclusion;
         },
         [](const Words& words) {
           return "is the allowed error of approximations and needs " + words("sum", Sum::Tree) +
                  ", " + words("transport", Transport::Boundary) + " or " +
                  words("ambient_occlusion", true);
         }},
    Rule{"max_surfels", [](const RenderOptions& options) { return options.sum == Sum::Pattern; },
         [](const Words& words) { return "limits surfels " + needsSurfels(words); }},
    Rule{"max_clusters",
         [](const RenderOptions& options) {
           return options.transport != Transport::Boundary && !options.ambientOcclusion;
         },
         [](const Words& words) {
           return "limits clusters and needs " + words("transport", Transport::Boundary) + " or " +
                  words("ambient_occlusion", true);
         }},
    Rule{"bounces",
         [](const RenderOptions& options) { return options.transport != Transport::Boundary; },
         [](const Words& words) {
           return "counts how often light enters again and needs " +
                  words("transport", Transport::Boundary);
         }},
    Rule{"ambient_occlusion",
         [](const RenderOptions& options) { return options.transport == Transport::Boundary; },
         [](const Words& words) {
           return "hides the sky, as boundary transport always does, " +
                  needsAnotherTransport(words);
         }},
    Rule{"roughness", [](const RenderOptions& options) { return !options.specular; },
         [](const Words& words) {
           return "is of the reflection, which " + words("specular", false) + " turns off";
         }},
};

}  // namespace

std::optional<Unused> findUnused(const Chosen<PictureSettings>& chosen,
                                 const RenderOptions& options, Spelling spelling) {
  for (const Rule& rule : rules)
    if (chosen.has(rule.key) && rule.isUnused(options))
      return Unused{rule.key, rule.why(Words(spelling))};
  return std::nullopt;
}

void chooseTransport(RenderOptions& options) {
  if (options.sum == Sum::Pattern) options.transport = Transport::Dipole;
}

}  // namespace opaline::options
