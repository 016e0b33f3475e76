#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "cli/motion_options.h"
#include "opaline/numbered_name.h"

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
  explicit FrameNames(NumberedName name) : name_(std::move(name)) {}

  NumberedName name_;
};

/// A name for a row of pictures of which none is there: NAME_%04d.png, or else NAME-2_%04d.png, and
/// so on.
std::filesystem::path freeRow(const std::string& name, const std::string& ending,
                              const FrameRange& frames);

/// Where a frame goes: the output itself, or what its mark for the number makes of it.
std::filesystem::path fileOf(const std::filesystem::path& output, int frame);

}  // namespace opaline::app
