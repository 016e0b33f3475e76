#include "scene/toml/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

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

void TomlTable::requireKeys(std::span<const std::string_view> known,
                            std::span<const std::string_view> hidden) const {
  const auto holds = [](std::span<const std::string_view> keys, std::string_view key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
  };
  for (const auto& [key, value] : table_) {
    if (holds(known, key.str()) || holds(hidden, key.str())) continue;
    fail(key.str(), "is not a known key" + suggestionOrList(key.str(), known, known.size()));
  }
}

std::optional<std::string> TomlTable::text(std::string_view key) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_string()) fail(key, "must be text in quotes");
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

namespace {

/// Reads "1024x1024", the form of the command line.
std::optional<options::Size> sizeFromText(std::string_view text) {
  options::Size edges{};
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, edges[0]);
  if (width.ec != std::errc() || width.ptr == end || *width.ptr != 'x') return std::nullopt;
  const auto height = std::from_chars(width.ptr + 1, end, edges[1]);
  if (height.ec != std::errc() || height.ptr != end) return std::nullopt;
  return edges;
}

void read(const toml::node& node, double& to, bool& good) {
  const auto value = node.is_number() ? node.value<double>() : std::nullopt;
  good = good && value.has_value();
  to = value.value_or(0);
}

void read(const toml::node& node, float& to, bool& good) {
  double value = 0;
  read(node, value, good);
  good = good && std::abs(value) <= double{std::numeric_limits<float>::max()};
  if (good) to = static_cast<float>(value);
}

void read(const toml::node& node, int& to, bool& good) {
  const auto value = node.is_integer() ? node.value<std::int64_t>() : std::nullopt;
  good = good && value && *value >= std::numeric_limits<int>::min() &&
         *value <= std::numeric_limits<int>::max();
  if (good) to = static_cast<int>(*value);
}

void read(const toml::node& node, bool& to, bool& good) {
  good = node.is_boolean();
  to = node.value<bool>().value_or(false);
}

void read(const toml::node& node, std::string& to, bool& good) {
  good = node.is_string();
  to = node.value<std::string>().value_or("");
}

template <typename Number, std::size_t count>
void read(const toml::node& node, std::array<Number, count>& to, bool& good) {
  if (const toml::array* list = node.as_array()) {
    good = list->size() == count;
    for (std::size_t i = 0; good && i < count; ++i) read(*list->get(i), to[i], good);
  } else if (count == 3) {
    read(node, to[0], good);
    to.fill(to[0]);
  } else if constexpr (std::is_same_v<std::array<Number, count>, options::Size>) {
    const auto size = sizeFromText(node.value<std::string>().value_or(""));
    good = size.has_value();
    to = size.value_or(to);
  }
}

}  // namespace

std::optional<options::Value> TomlTable::value(std::string_view key,
                                               const options::Allowed& allowed,
                                               const options::Value& like) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) return std::nullopt;
  const auto named = node->value<std::string>();
  if (named &&
      std::find(allowed.choices.begin(), allowed.choices.end(), *named) != allowed.choices.end())
    return *named;
  if (std::holds_alternative<std::string>(like) && allowed.range.most > 0) {
    const auto number = node->is_integer() ? node->value<std::int64_t>() : std::nullopt;
    if (number && allowed.range.holds(static_cast<double>(*number)))
      return fmt::format("{}", *number);
  }
  options::Value value = like;
  bool good = true;
  std::visit([&](auto& member) { read(*node, member, good); }, value);
  if (!good || !allowed.holds(value)) fail(key, options::typedRequirement(allowed, like));
  return value;
}

std::optional<double> TomlTable::number(std::string_view key, const options::Range& range) const {
  const auto found = value(key, {range}, 0.0);
  return found ? std::optional(std::get<double>(*found)) : std::nullopt;
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
  // A vector that was rounded to float at unit length must come back unchanged.
  if (std::abs(size - 1) < 1e-6) return toFloat(v);
  return toFloat((1 / size) * v);
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

std::optional<Vec3> placeFrom(const TomlTable& table, std::string_view key, const Vec3& centreMm) {
  const auto offset = table.numbers(key, 3);
  if (!offset) return std::nullopt;
  return toFloat(toDouble(centreMm) + Double3{(*offset)[0], (*offset)[1], (*offset)[2]});
}

}  // namespace opaline::scene
