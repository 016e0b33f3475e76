#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace opaline::app {

/// A name of many files: one %d or %04d stands for the number.
class FrameNames {
 public:
  /// Nothing where the text holds no such mark, or two.
  static std::optional<FrameNames> parse(const std::string& text);

  std::filesystem::path file(int number) const;

  /// What all of them have in common and no mark in it: "bear" of bear_%04d.
  std::string common() const;

 private:
  std::string before_;
  std::string after_;
  int digits_ = 0;
};

}  // namespace opaline::app
