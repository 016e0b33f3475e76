#include "opaline/options/field.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "opaline/error.h"

namespace opaline::options {

namespace {

template <typename... Kinds>
struct Overloaded : Kinds... {
  using Kinds::operator()...;
};
template <typename... Kinds>
Overloaded(Kinds...) -> Overloaded<Kinds...>;

std::string listed(const std::vector<int>& counts) {
  std::string text;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (i > 0) text += i + 1 < counts.size() ? ", " : " or ";
    text += fmt::format("{}", counts[i]);
  }
  return text;
}

template <typename Number>
bool isIn(Number number, const Range& range) {
  return range.holds(static_cast<double>(number));
}

// A limit that float rounds is the limit.
bool isIn(float number, const Range& range) {
  return range.holds(static_cast<double>(number)) ||
         (number == static_cast<float>(range.least) && !range.aboveLeast) ||
         number == static_cast<float>(range.most);
}

// `size` and `triple` say what form several numbers have.
std::string requirement(const Allowed& allowed, const Value& like, std::string_view size,
                        std::string_view triple) {
  const std::string range = describe(allowed.range);
  const bool orNamed = !allowed.choices.empty() && !std::holds_alternative<std::string>(like);
  if (orNamed)
    return fmt::format("{}, or {}",
                       requirement({allowed.range, {}, allowed.counts}, like, size, triple),
                       fmt::join(allowed.choices, " or "));
  return std::visit(
      Overloaded{[](bool) -> std::string { return "must be true or false"; },
                 [&](int) {
                   return allowed.counts.empty()
                              ? fmt::format("must be a whole number {}", range)
                              : fmt::format("must be {}", listed(allowed.counts));
                 },
                 [&](const std::string&) -> std::string {
                   if (allowed.choices.empty())
                     return allowed.range.most > 0
                                ? fmt::format("must be a name, or a number {}", range)
                                : "must be a name";
                   return fmt::format("must be {}{}", allowed.choices.size() == 1 ? "" : "one of ",
                                      fmt::join(allowed.choices, ", "));
                 },
                 [&](const Size&) { return fmt::format("must be {}, each {}", size, range); },
                 [&](const auto& number) {
                   if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(number)>>)
                     return fmt::format("must be {}", range);
                   else
                     return fmt::format("must be {}, each {}", triple, range);
                 }},
      like);
}

}  // namespace

bool Allowed::holds(const Value& value) const {
  return std::visit(
      Overloaded{[](bool) { return true; },
                 [&](int number) {
                   return isIn(number, range) &&
                          (counts.empty() ||
                           std::find(counts.begin(), counts.end(), number) != counts.end());
                 },
                 [&](float number) { return isIn(number, range); },
                 [&](double number) { return isIn(number, range); },
                 [&](const std::string& text) {
                   if (choices.empty()) return !text.empty();
                   return std::find(choices.begin(), choices.end(), text) != choices.end();
                 },
                 [&](const auto& several) {
                   return std::all_of(several.begin(), several.end(),
                                      [&](auto number) { return isIn(number, range); });
                 }},
      value);
}

std::string requirement(const Allowed& allowed, const Value& like) {
  return requirement(allowed, like, "a width and a height", "three numbers");
}

std::string typedRequirement(const Allowed& allowed, const Value& like) {
  return requirement(allowed, like, "WIDTHxHEIGHT", "three numbers or one for all three");
}

std::size_t indexOf(std::string_view name, std::span<const std::string_view> names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw UsageError(fmt::format("'{}' is none of {}", name, fmt::join(names, ", ")));
  return static_cast<std::size_t>(found - names.begin());
}

std::string textOf(const Value& value) {
  return std::visit(
      Overloaded{[](const Size& size) { return fmt::format("{}x{}", size[0], size[1]); },
                 [](const auto& other) {
                   using Kind = std::remove_cvref_t<decltype(other)>;
                   if constexpr (std::is_arithmetic_v<Kind> || std::is_same_v<Kind, std::string>)
                     return fmt::format("{}", other);
                   else
                     return fmt::format("{}", fmt::join(other, ","));
                 }},
      value);
}

}  // namespace opaline::options
