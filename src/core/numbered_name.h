#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace opaline::core {

/// A name of many files, with one %d or %0Nd, N from 1 to 9, where the number stands.
class NumberedName {
 public:
  /// Nothing where the text holds no such mark, or two.
  static std::optional<NumberedName> parse(std::string_view text);

  std::string with(int number) const;
  /// The number of a name that with() makes; nothing for any other.
  std::optional<int> numberOf(std::string_view name) const;

  const std::string& before() const { return before_; }
  const std::string& after() const { return after_; }

 private:
  std::string before_;
  std::string after_;
  std::size_t digits_ = 0;  ///< padded with zeros to as many
};

}  // namespace opaline::core
