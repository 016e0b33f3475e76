#include "film/picture_row.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <system_error>

#include "cli/frame_names.h"
#include "cli/paths.h"
#include "film/picture_stamp.h"
#include "opaline/error.h"
#include "opaline/image_file.h"
#include "opaline/numbered_name.h"
#include "opaline/tone.h"

namespace opaline::app {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view digits = "0123456789";

std::vector<std::string> namesIn(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code problem;
  for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end;
       entry.increment(problem)) {
    names.push_back(entry->path().filename().string());
  }
  if (problem) {
    throw Error(fmt::format("{} cannot be listed: {}", folder.string(), problem.message()));
  }
  return names;
}

/// The pattern that a picture's name may belong to: frame_%04d.png for frame_0012.png.
std::optional<std::string> patternOf(const std::string& name) {
  const std::string extension = extensionOf(name);
  if (name.front() == '.' || (extension != ".png" && extension != ".exr")) return std::nullopt;
  const std::string stem = name.substr(0, name.size() - extension.size());
  const std::size_t count = stem.size() - (stem.find_last_not_of(digits) + 1);
  if (count == 0 || count > 9) return std::nullopt;
  const bool padded = count > 1 && stem[stem.size() - count] == '0';
  return fmt::format("{}{}{}", stem.substr(0, stem.size() - count),
                     padded ? fmt::format("%0{}d", count) : "%d", name.substr(stem.size()));
}

/// Drops patterns whose pictures belong to others: frame_1000.png fits frame_%d.png as well as
/// frame_%04d.png.
void dropWhatOthersHold(std::set<std::string>& patterns, const std::vector<std::string>& names) {
  std::erase_if(patterns, [&](const std::string& text) {
    const auto pattern = NumberedName::parse(text);
    if (!pattern) return true;
    return std::any_of(patterns.begin(), patterns.end(), [&](const std::string& otherText) {
      const auto other = NumberedName::parse(otherText);
      return otherText != text && other &&
             std::all_of(names.begin(), names.end(), [&](const std::string& name) {
               return !pattern->numberOf(name) || other->numberOf(name);
             });
    });
  });
}

std::string onlyPatternIn(const fs::path& folder) {
  const std::vector<std::string> names = namesIn(folder);
  std::set<std::string> patterns;
  for (const std::string& name : names)
    if (auto pattern = patternOf(name)) patterns.insert(std::move(*pattern));
  dropWhatOthersHold(patterns, names);
  if (patterns.empty()) {
    throw Error(fmt::format(
        "{} has no numbered pictures: frame_0000.png or .exr, as render --frames makes them",
        folder.string()));
  }
  if (patterns.size() > 1) {
    throw UsageError(fmt::format("{} has several rows of pictures, {}: name one of them, as {}",
                                 folder.string(), fmt::join(patterns, " and "),
                                 (folder / *patterns.begin()).string()));
  }
  return *patterns.begin();
}

FrameRange framesThere(const fs::path& names) {
  const auto name = NumberedName::parse(names.filename().string());
  FrameRange frames{std::numeric_limits<int>::max(), -1};
  const fs::path folder = names.has_parent_path() ? names.parent_path() : fs::path(".");
  for (const std::string& file : namesIn(folder)) {
    const std::optional<int> number = name->numberOf(file);
    if (!number) continue;
    frames.first = std::min(frames.first, *number);
    frames.last = std::max(frames.last, *number);
  }
  if (frames.last < 0) {
    throw Error(fmt::format("{}: there is no picture of this name", names.string()));
  }
  return frames;
}

/// Text such as "4, 10 to 12", for ascending numbers.
std::string numbersText(const std::vector<int>& numbers, int step) {
  constexpr std::size_t most = 8;
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < numbers.size() && parts.size() <= most; ++i) {
    if (parts.size() == most) {
      parts.emplace_back("…");
      break;
    }
    const int first = numbers[i];
    while (i + 1 < numbers.size() && numbers[i + 1] == numbers[i] + step) ++i;
    parts.push_back(numbers[i] == first ? fmt::format("{}", first)
                                        : fmt::format("{} to {}", first, numbers[i]));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// Of frames with gaps between those that are there. Where these are as far apart as frames that
/// are rendered with a step, the gaps may be meant.
std::string cureOfGaps(const FrameRange& frames, const std::vector<int>& there) {
  const int step = there.size() > 2 ? there[1] - there[0] : frames.step;
  bool isEven = step > frames.step;
  for (std::size_t i = 1; i < there.size(); ++i) isEven = isEven && there[i] - there[i - 1] == step;
  if (!isEven) return "render --resume makes them";
  return fmt::format(
      "--frames {}:{}:{} leaves out what is missing, render --resume --frames {}:{} makes it",
      there.front(), there.back(), step, frames.first, frames.last);
}

Image firstPicture(const PictureRow& row) {
  std::error_code ignored;
  for (int frame = row.frames.first; frame <= row.frames.last; frame += row.frames.step)
    if (fs::exists(row.file(frame), ignored)) return readPicture(row, frame);
  throw Error(fmt::format("{}: none of frames {} to {} is there", row.names.string(),
                          row.frames.first, row.frames.last));
}

}  // namespace

fs::path PictureRow::file(int frame) const {
  return names.parent_path() / fileOf(names.filename(), frame);
}

bool PictureRow::isExr() const {
  return extensionOf(names) == ".exr";
}

PictureRow findPictureRow(const fs::path& given, const std::optional<FrameRange>& frames) {
  PictureRow row{given, {}};
  std::error_code ignored;
  if (fs::is_directory(given, ignored)) {
    row.names = given / onlyPatternIn(given);
  } else if (!NumberedName::parse(given.filename().string())) {
    throw Error(
        fmt::format("{}: it is neither a folder nor a name with one %d or %04d", given.string()));
  }
  if (const std::string extension = extensionOf(row.names);
      extension != ".png" && extension != ".exr") {
    throw UsageError(fmt::format("{}: a film is made of .png or .exr pictures", given.string()));
  }
  row.frames = frames ? *frames : framesThere(row.names);
  return row;
}

Image readPicture(const PictureRow& row, int frame) {
  if (row.isExr()) return readHdrImage(row.file(frame), Negatives::Stay);
  Image image = readPng(row.file(frame));
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    if (i % 4 != 3) image.rgba[i] = decodeSrgb(image.rgba[i]);
  return image;
}

void requireWhole(const PictureRow& row) {
  const Image first = firstPicture(row);
  std::vector<int> missing;
  std::vector<int> broken;
  std::vector<int> there;
  std::error_code ignored;
  for (int frame = row.frames.first; frame <= row.frames.last; frame += row.frames.step) {
    const fs::path file = row.file(frame);
    const bool isThere = fs::exists(file, ignored);
    if (isThere) there.push_back(frame);
    if (isWholeImage(file, first.width, first.height)) continue;
    (isThere ? broken : missing).push_back(frame);
  }
  if (missing.empty() && broken.empty()) return;
  std::vector<std::string> complaints;
  const auto complain = [&](const std::vector<int>& numbers, std::string_view what) {
    if (numbers.empty()) return;
    const std::string of =
        complaints.empty() ? fmt::format(" of {} frames", row.frames.count()) : "";
    complaints.push_back(fmt::format("{}{} {} {} ({})", numbers.size(), of,
                                     numbers.size() == 1 ? "is" : "are", what,
                                     numbersText(numbers, row.frames.step)));
  };
  complain(missing, "missing");
  complain(broken, fmt::format("damaged or not {}x{}", first.width, first.height));
  throw Error(fmt::format("{}: {}; {}", row.names.string(), fmt::join(complaints, " and "),
                          cureOfGaps(row.frames, there)));
}

std::optional<double> framesPerSecondOf(const PictureRow& row) {
  const auto secondsAt = [&](int frame) -> std::optional<double> {
    const auto stamp = readImageNote(row.file(frame));
    return stamp ? secondsOf(*stamp) : std::nullopt;
  };
  const int frame = row.frames.last;
  const std::optional<double> seconds = secondsAt(frame);
  if (!seconds || *seconds <= 0) return std::nullopt;
  const double speed = frame / *seconds;
  // Rounds away the error of the division to the number that was typed.
  const double typed = std::round(speed * 1e6) / 1e6;
  return typed >= 1 && typed <= 1000 ? std::optional(typed) : std::nullopt;
}

std::optional<std::string> noteOnOthers(const PictureRow& row) {
  const std::string first = readImageNote(row.file(row.frames.first)).value_or("");
  std::size_t others = 0;
  std::string one;
  for (int frame = row.frames.first; frame <= row.frames.last; frame += row.frames.step) {
    if (isSameRow(readImageNote(row.file(frame)).value_or(""), first)) continue;
    if (others++ == 0) one = row.file(frame).string();
  }
  if (others == 0) return std::nullopt;
  return fmt::format(
      "{} of {} pictures, {} among them, were made from another scene or with other options than "
      "the first; render --resume makes them again",
      others, row.frames.count(), one);
}

}  // namespace opaline::app
