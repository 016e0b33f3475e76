#include "scene/toml/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "opaline/error.h"
#include "scene/text.h"
#include "scene/vector_math.h"

namespace opaline::scene {

void TomlTable::fail(std::string_view key, const std::string& reason) const {
  const toml::node* node = key.empty() ? nullptr : table_.get(key);
  const auto line = (node != nullptr ? node->source() : table_.source()).begin.line;
  const std::string subject =
      key.empty() ? place_ : fmt::format("'{}' in {}", cleanText(key, 60), place_);
  throw Error(
      fmt::format("{}, line {}: {} {}", cleanText(file_.string(), 1000), line, subject, reason));
}

void TomlTable::requireKeys(std::span<const std::string_view> known) const {
  for (const auto& [key, value] : table_) {
    if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
    fail(key.str(), fmt::format("is no known key; the nearest is '{}'",
                                nearest(key.str(), known).value_or("")));
  }
}

std::optional<std::string> TomlTable::text(std::string_view key) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_string()) fail(key, "must be a text in quotes");
  return node->value<std::string>();
}

std::optional<std::string> TomlTable::choice(std::string_view key,
                                             std::span<const std::string_view> choices) const {
  auto chosen = text(key);
  if (chosen && std::find(choices.begin(), choices.end(), *chosen) == choices.end()) {
    fail(key,
         fmt::format("is '{}', but the choices are {}", cleanText(*chosen, 40), listed(choices)));
  }
  return chosen;
}

std::optional<bool> TomlTable::flag(std::string_view key) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_boolean()) fail(key, "must be true or false");
  return node->value<bool>();
}

std::optional<double> TomlTable::number(std::string_view key, double low, double high) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_number()) fail(key, "must be a number");
  const auto value = node->value<double>();
  if (!value || !(*value >= low && *value <= high)) {
    fail(key, fmt::format("must be in [{}, {}]", low, high));
  }
  return value;
}

std::optional<int> TomlTable::integer(std::string_view key, int low, int high) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return std::nullopt;
  const auto value = node->is_integer() ? node->value<std::int64_t>() : std::nullopt;
  if (!value || *value < low || *value > high) {
    fail(key, fmt::format("must be a whole number in [{}, {}]", low, high));
  }
  return static_cast<int>(*value);
}

std::optional<std::vector<double>> TomlTable::numbers(std::string_view key,
                                                      std::size_t count) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return std::nullopt;
  const toml::array* list = node->as_array();
  std::vector<double> values;
  for (std::size_t i = 0; list != nullptr && list->size() == count && i < count; ++i) {
    const toml::node* entry = list->get(i);
    const auto value = entry->is_number() ? entry->value<double>() : std::nullopt;
    if (value && std::abs(*value) <= 1e30) values.push_back(*value);
  }
  if (values.size() != count) fail(key, fmt::format("must be a list of {} finite numbers", count));
  return values;
}

std::optional<Vec3> TomlTable::vector(std::string_view key) const {
  const auto values = numbers(key, 3);
  if (!values) return std::nullopt;
  return toFloat({(*values)[0], (*values)[1], (*values)[2]});
}

std::optional<Vec3> TomlTable::direction(std::string_view key) const {
  const auto values = numbers(key, 3);
  if (!values) return std::nullopt;
  const Double3 v{(*values)[0], (*values)[1], (*values)[2]};
  const double size = length(v);
  if (!(size > 1e-30)) fail(key, "must not be zero");
  // What was rounded to float at unit length comes back as it was.
  if (std::abs(size - 1) < 1e-6) return toFloat(v);
  return toFloat((1 / size) * v);
}

std::optional<Rgb> TomlTable::color(std::string_view key) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return std::nullopt;
  if (node->is_number()) {
    const auto value = static_cast<float>(number(key, 0, 1e30).value_or(0));
    return Rgb{value, value, value};
  }
  const auto rgb = vector(key);
  if (rgb && *std::min_element(rgb->begin(), rgb->end()) < 0) fail(key, "must not be negative");
  return rgb;
}

std::optional<TomlTable> TomlTable::table(std::string_view key) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_table()) fail(key, "must be a table");
  return TomlTable(file_, *node->as_table(), fmt::format("[{}]", cleanText(key, 60)));
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
  std::vector<TomlTable> result;
  const toml::node* node = table_.get(key);
  if (node == nullptr) return result;
  const toml::array* list = node->as_array();
  if (list == nullptr) fail(key, fmt::format("must be tables, each under [[{}]]", key));
  for (const toml::node& entry : *list) {
    if (!entry.is_table()) fail(key, fmt::format("must be tables, each under [[{}]]", key));
    result.emplace_back(file_, *entry.as_table(), fmt::format("[[{}]]", cleanText(key, 60)));
  }
  return result;
}

std::vector<std::pair<std::string, TomlTable>> TomlTable::subtables() const {
  std::vector<std::pair<std::string, TomlTable>> result;
  for (const auto& [key, value] : table_) {
    if (!value.is_table()) fail(key.str(), "must be a table");
    std::string inner = place_;
    if (inner.ends_with(']')) inner.pop_back();
    result.emplace_back(std::string(key.str()),
                        TomlTable(file_, *value.as_table(),
                                  fmt::format("{}.{}]", inner, cleanText(key.str(), 60))));
  }
  return result;
}

}  // namespace opaline::scene
