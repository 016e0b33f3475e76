#include "cli/frame_names.h"

#include <fmt/format.h>

#include <utility>

#include "opaline/file.h"

namespace opaline::app {

std::optional<FrameNames> FrameNames::parse(const std::string& text) {
  auto name = NumberedName::parse(text);
  return name ? std::optional(FrameNames(std::move(*name))) : std::nullopt;
}

std::string FrameNames::common() const {
  const std::string& before = name_.before();
  const std::string name = before.substr(0, before.find_last_not_of("_-. ") + 1) + name_.after();
  return name.empty() ? "frame" : name;
}

std::filesystem::path freeRow(const std::string& name, const std::string& ending,
                              const FrameRange& frames) {
  const auto isFree = [&](const std::filesystem::path& row) {
    for (int frame = frames.first; frame <= frames.last; frame += frames.step) {
      const std::filesystem::path file = fileOf(row, frame);
      if (freeName(file) != file) return false;
    }
    return true;
  };
  std::filesystem::path row = name + "_%04d" + ending;
  for (int number = 2; !isFree(row); ++number) {
    row = fmt::format("{}-{}_%04d{}", name, number, ending);
  }
  return row;
}

std::filesystem::path fileOf(const std::filesystem::path& output, int frame) {
  const std::optional<FrameNames> names = FrameNames::parse(output.string());
  return names ? names->file(frame) : output;
}

}  // namespace opaline::app
