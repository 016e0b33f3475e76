#pragma once

#include <span>
#include <string>
#include <string_view>

#include "cli/command_line.h"
#include "cli/values.h"
#include "options/field.h"

namespace opaline::app {

/// "--near-spacing" of near_spacing.
std::string optionOf(std::string_view key);

/// "X", "N", "NAME", "R,G,B", "WxH".
std::string placeholderOf(const options::Value& like);

/// "samples around the middle one, 0 to 15 [4]".
std::string helpOf(std::string_view help, const options::Allowed& allowed,
                   const options::Value& like, const std::string& standard);

/// Takes what is typed for an option of the table; what is on by itself is turned off, by --no-KEY.
template <typename Owner>
void addField(CommandLine& line, const options::Field<Owner>& field, options::Chosen<Owner>& chosen,
              std::string option = {}) {
  if (std::holds_alternative<bool>(field.like)) {
    line.flag("--no-" + optionOf(field.key).substr(2), "without the " + std::string(field.help),
              [&] { chosen.set(field, false); });
    return;
  }
  if (option.empty()) option = optionOf(field.key);
  std::string standard{field.standard};
  if (const auto value = field.get(Owner{}); standard.empty() && value)
    standard = options::textOf(*value);
  line.value(
      option, placeholderOf(field.like), helpOf(field.help, field.allowed, field.like, standard),
      [&](const Given& given) { chosen.set(field, readValue(given, field.allowed, field.like)); });
  if (!field.formerKey.empty()) line.synonym(optionOf(field.formerKey), option);
}

template <typename Owner>
void addFields(CommandLine& line, std::span<const std::string_view> keys,
               options::Chosen<Owner>& chosen) {
  for (const std::string_view key : keys) addField(line, options::fieldOf<Owner>(key), chosen);
}

}  // namespace opaline::app
