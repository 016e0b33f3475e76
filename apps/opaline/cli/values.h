#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/command_line.h"
#include "opaline/options/field.h"

namespace opaline::app {

using options::Range;

/// The parts between the separators, one more than there are separators.
std::vector<std::string_view> split(std::string_view text, char separator);

/// Whether it is one as people write them, "nan" and "inf" among them.
bool isNumber(std::string_view text);

/// A finite number in the range. Throws UsageError that names the option, the reason and the range,
/// as all readers here do.
double readNumber(const Given& given, const Range& range);

int readInteger(const Given& given, int least, int most);

/// X,Y,Z, each in the range.
std::array<float, 3> readPlace(const Given& given, const Range& range);

/// R,G,B, each in the range, or one number for all three.
std::array<double, 3> readChannels(const Given& given, const Range& range);
std::array<float, 3> readColour(const Given& given, const Range& range);

/// X,Y,Z of any length but 0, normalised.
std::array<float, 3> readDirection(const Given& given);

/// WIDTHxHEIGHT, each in the range.
std::array<int, 2> readSize(const Given& given, const Range& range);

/// A value of the type of `like`.
options::Value readValue(const Given& given, const options::Allowed& allowed,
                         const options::Value& like);

/// Throws UsageError that lists the choices.
[[noreturn]] void refuseChoice(const Given& given, const std::vector<std::string>& choices);

template <typename T>
using Choices = std::vector<std::pair<std::string, T>>;

template <typename T>
T readChoice(const Given& given, const Choices<T>& choices) {
  std::vector<std::string> names;
  for (const auto& [name, meaning] : choices) {
    if (name == given.text) return meaning;
    names.push_back(name);
  }
  refuseChoice(given, names);
}

/// All values of an enumeration.
template <typename Enumeration>
const Choices<Enumeration>& choicesOf() {
  static const Choices<Enumeration> choices = [] {
    Choices<Enumeration> made;
    for (const std::string_view name : options::namesOf<Enumeration>())
      made.emplace_back(name, options::named<Enumeration>(name));
    return made;
  }();
  return choices;
}

}  // namespace opaline::app
