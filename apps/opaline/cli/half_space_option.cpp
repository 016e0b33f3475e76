#include "cli/half_space_option.h"

#include <fmt/format.h>

#include "cli/picture_options.h"
#include "cli/values.h"

namespace opaline::app {

void HalfSpaceOption::addTo(CommandLine& line) {
  line.value(
      "--transport", "NAME", "boundary, better-dipole or dipole [boundary]",
      [this](const Given& given) { transport_ = readChoice(given, choicesOf<Transport>()); });
}

std::string HalfSpaceOption::name() const {
  return options::nameOf(transport_ == Transport::Boundary ? Transport::BetterDipole : transport_);
}

std::string HalfSpaceOption::label() const {
  return transport_ == Transport::Boundary
             ? fmt::format("{}, the half-space of boundary transport", name())
             : name();
}

void HalfSpaceOption::describe(Json& json) const {
  json["transport"] = options::nameOf(transport_);
  json["half_space"] = name();
}

}  // namespace opaline::app
