#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <toml++/toml.h>

#include "opaline/types.h"

namespace opaline::scene {

/// A table of a .toml scene, read key by key. Every problem is an Error that names file, line and
/// key; keys that nobody asked for are a problem too.
class TomlTable {
 public:
  TomlTable(const std::filesystem::path& file, const toml::table& table, std::string place)
      : file_(file), table_(table), place_(std::move(place)) {}

  /// Throws Error for a key that is not among `known`, naming the nearest.
  void requireKeys(std::span<const std::string_view> known) const;

  bool has(std::string_view key) const { return table_.contains(key); }
  bool holdsText(std::string_view key) const {
    return table_.get(key) && table_.get(key)->is_string();
  }
  std::optional<std::string> text(std::string_view key) const;
  std::optional<std::string> choice(std::string_view key,
                                    std::span<const std::string_view> choices) const;
  std::optional<bool> flag(std::string_view key) const;
  std::optional<double> number(std::string_view key, double low, double high) const;
  std::optional<int> integer(std::string_view key, int low, int high) const;
  /// As many finite numbers as are asked for.
  std::optional<std::vector<double>> numbers(std::string_view key, std::size_t count) const;
  std::optional<Vec3> vector(std::string_view key) const;
  /// A vector that is not zero, at unit length to the rounding of float.
  std::optional<Vec3> direction(std::string_view key) const;
  /// Three numbers of at least 0, or one for all three.
  std::optional<Rgb> color(std::string_view key) const;
  std::optional<TomlTable> table(std::string_view key) const;
  /// The entries of an array of tables.
  std::vector<TomlTable> tables(std::string_view key) const;
  /// The keys of this table that hold tables; others are an Error.
  std::vector<std::pair<std::string, TomlTable>> subtables() const;

  /// Throws Error about a key, or about the table itself if the key is empty.
  [[noreturn]] void fail(std::string_view key, const std::string& reason) const;

 private:
  const std::filesystem::path& file_;
  const toml::table& table_;
  std::string place_;  ///< "[camera]" for messages
};

}  // namespace opaline::scene
