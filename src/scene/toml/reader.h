#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <toml++/toml.h>

#include "opaline/options/field.h"
#include "opaline/types.h"

namespace opaline::scene {

/// A table of a .toml scene, read key by key. Every problem is an Error that names file, line and
/// key; keys that nobody asked for are a problem too.
class TomlTable {
 public:
  TomlTable(const std::filesystem::path& file, const toml::table& table, std::string place)
      : file_(file), table_(table), place_(std::move(place)) {}

  /// Throws Error for a key that is neither among `known` nor among `hidden`; the message names the
  /// nearest known key.
  void requireKeys(std::span<const std::string_view> known,
                   std::span<const std::string_view> hidden = {}) const;

  bool has(std::string_view key) const { return table_.contains(key); }
  bool holdsText(std::string_view key) const {
    return table_.get(key) && table_.get(key)->is_string();
  }
  std::optional<std::string> text(std::string_view key) const;
  std::optional<std::string> choice(std::string_view key,
                                    std::span<const std::string_view> choices) const;
  /// A value of the type of `like`. One number may stand for three, and text for a size.
  std::optional<options::Value> value(std::string_view key, const options::Allowed& allowed,
                                      const options::Value& like) const;
  std::optional<double> number(std::string_view key, const options::Range& range) const;
  /// Exactly `count` finite numbers.
  std::optional<std::vector<double>> numbers(std::string_view key, std::size_t count) const;
  std::optional<Vec3> vector(std::string_view key) const;
  /// A vector that is not zero, at unit length to the rounding of float.
  std::optional<Vec3> direction(std::string_view key) const;
  std::optional<TomlTable> table(std::string_view key) const;
  /// The entries of an array of tables.
  std::vector<TomlTable> tables(std::string_view key) const;
  /// All keys of this table, each of which must hold a table. Throws Error for others.
  std::vector<std::pair<std::string, TomlTable>> subtables() const;

  /// Throws Error about a key, or about the table itself if the key is empty.
  [[noreturn]] void fail(std::string_view key, const std::string& reason) const;

 private:
  const std::filesystem::path& file_;
  const toml::table& table_;
  std::string place_;  ///< "[camera]" for messages
};

/// A place that is given relative to the centre. Double precision allows every place to be given.
std::optional<Vec3> placeFrom(const TomlTable& table, std::string_view key, const Vec3& centreMm);

/// The values that the table gives for an Owner's options, including those under older names.
/// Throws Error for an option under both of its names.
template <typename Owner>
options::Chosen<Owner> chosenIn(const TomlTable& table) {
  options::Chosen<Owner> chosen;
  for (const options::Field<Owner>& field : options::fieldsOf<Owner>())
    for (const std::string_view key : {field.formerKey, field.key}) {
      auto value = key.empty() ? std::nullopt : table.value(key, field.allowed, field.like);
      if (!value) continue;
      if (chosen.has(field.key))
        table.fail(key, "stands beside '" + std::string(field.formerKey) +
                            "', its older name: keep one of the two");
      chosen.set(field, *std::move(value));
    }
  return chosen;
}

}  // namespace opaline::scene
