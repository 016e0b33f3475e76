#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "core/numbered_name.h"

namespace opaline::app {

/// Names of the pictures of a film, or of the meshes of a sequence: one %d or %04d in them.
class FrameNames {
 public:
  /// Nothing where the text holds no such mark, or two.
  static std::optional<FrameNames> parse(const std::string& text);

  std::filesystem::path file(int number) const { return name_.with(number); }

  /// What all of them have in common and no mark in it: "bear" of bear_%04d.
  std::string common() const;

 private:
  explicit FrameNames(core::NumberedName name) : name_(std::move(name)) {}

  core::NumberedName name_;
};

}  // namespace opaline::app
