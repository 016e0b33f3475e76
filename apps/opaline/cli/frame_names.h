#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "cli/motion_options.h"
#include "opaline/numbered_name.h"

namespace opaline::app {

/// Names of a film's pictures or of a sequence's meshes, with one %d or %04d in them.
class FrameNames {
 public:
  /// None where the text has no such mark, or two.
  static std::optional<FrameNames> parse(const std::string& text);

  std::filesystem::path file(int number) const { return name_.with(number); }

  /// The part that all names share, without the mark: "bear" of bear_%04d.
  std::string common() const;

 private:
  explicit FrameNames(NumberedName name) : name_(std::move(name)) {}

  NumberedName name_;
};

/// A name for a row of pictures of which none exists yet: NAME_%04d.png, or else NAME-2_%04d.png,
/// and so on.
std::filesystem::path freeRow(const std::string& name, const std::string& ending,
                              const FrameRange& frames);

/// The file of a frame: the output itself, or its name with the number in place of the mark.
std::filesystem::path fileOf(const std::filesystem::path& output, int frame);

}  // namespace opaline::app
