#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "opaline/export.h"

namespace opaline {

/// A pattern for the names of many files, such as the pictures of a film or the meshes of a
/// MeshSequence. One %d or %0Nd, N from 1 to 9, marks the place of the number.
class OPALINE_API NumberedName {
 public:
  /// Nothing unless the text has exactly one such mark.
  static std::optional<NumberedName> parse(std::string_view text);

  /// The name of the file with that number.
  std::string with(int number) const;
  /// The number of a name that with() can make; nothing for any other.
  std::optional<int> numberOf(std::string_view name) const;

  /// The text before the mark, and the text after it.
  const std::string& before() const { return before_; }
  const std::string& after() const { return after_; }

 private:
  std::string before_;
  std::string after_;
  std::size_t digits_ = 0;  // least width of the number, padded with zeros
};

}  // namespace opaline
