#pragma once

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command_line.h"
#include "cli/values.h"
#include "opaline/options/field.h"

namespace opaline::app {

/// Makes "--near-spacing" of near_spacing.
std::string optionOf(std::string_view key);

/// "X", "N", "NAME", "R,G,B", "WxH".
std::string placeholderOf(const options::Value& like);

/// "rings around the middle sample, 0 to 15 [4]".
std::string helpOf(std::string_view help, const options::Allowed& allowed,
                   const options::Value& like, const std::string& standard);

/// The default in the form that the help shows.
template <typename Owner>
std::string standardOf(const options::Field<Owner>& field) {
  if (!field.standard.empty()) return std::string(field.standard);
  const auto value = field.get(Owner{});
  return value ? options::textOf(*value) : "";
}

/// What is typed to give an option of the table a value that is not its default: "--sum pattern",
/// "--no-specular".
template <typename Owner>
std::string asTyped(const options::Field<Owner>& field, const options::Value& value) {
  const std::string option = optionOf(field.key);
  const bool* const flag = std::get_if<bool>(&value);
  if (flag == nullptr) return option + " " + options::textOf(value);
  return *flag ? option : "--no-" + option.substr(2);
}

/// Takes what is typed for an option of the table, under its own name and with its own help unless
/// others are given; what is on by itself is turned off, by --no-KEY.
template <typename Owner>
void addField(CommandLine& line, const options::Field<Owner>& field, options::Chosen<Owner>& chosen,
              std::string option = {}, const std::optional<std::string>& help = {}) {
  if (std::holds_alternative<bool>(field.like)) {
    const std::string name = optionOf(field.key);
    if (field.get(Owner{}) == options::Value{true})
      line.flag("--no-" + name.substr(2), "without the " + std::string(field.help),
                [&] { chosen.set(field, false); });
    else
      line.flag(name, std::string(field.help), [&] { chosen.set(field, true); });
    return;
  }
  if (option.empty()) option = optionOf(field.key);
  line.value(
      option, placeholderOf(field.like),
      help ? *help : helpOf(field.help, field.allowed, field.like, standardOf(field)),
      [&](const Given& given) { chosen.set(field, readValue(given, field.allowed, field.like)); });
  if (!field.formerKey.empty()) line.synonym(optionOf(field.formerKey), option);
}

/// Puts several options into one entry of the help, which names the default of each: "texels [512],
/// of shadows [1024]".
template <typename Owner>
void addTogether(CommandLine& line, std::initializer_list<std::string_view> keys,
                 std::initializer_list<std::string_view> words, options::Chosen<Owner>& chosen,
                 const std::vector<std::string>& names = {}) {
  std::string help;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const std::string standard = standardOf(options::fieldOf<Owner>(keys.begin()[i]));
    help += (i == 0 ? "" : ", ") + std::string(words.begin()[i]) + " [" + standard + "]";
  }
  for (std::size_t i = 0; i < keys.size(); ++i)
    addField(line, options::fieldOf<Owner>(keys.begin()[i]), chosen, names.empty() ? "" : names[i],
             i == 0 ? help : "");
}

template <typename Owner>
void addFields(CommandLine& line, std::span<const std::string_view> keys,
               options::Chosen<Owner>& chosen) {
  for (const std::string_view key : keys) addField(line, options::fieldOf<Owner>(key), chosen);
}

}  // namespace opaline::app
