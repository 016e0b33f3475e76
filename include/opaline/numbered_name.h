#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "opaline/export.h"

namespace opaline {

/// A name of many files, such as the pictures of a film or the meshes of a MeshSequence, with one
/// %d or %0Nd, N from 1 to 9, where the number stands.
class OPALINE_API NumberedName {
 public:
  /// Nothing where the text holds no such mark, or two.
  static std::optional<NumberedName> parse(std::string_view text);

  /// The name of the file with that number.
  std::string with(int number) const;
  /// The number of a name that with() makes; nothing for any other.
  std::optional<int> numberOf(std::string_view name) const;

  /// What stands before the mark, and what behind it.
  const std::string& before() const { return before_; }
  const std::string& after() const { return after_; }

 private:
  std::string before_;
  std::string after_;
  std::size_t digits_ = 0;  // padded with zeros to as many
};

}  // namespace opaline
