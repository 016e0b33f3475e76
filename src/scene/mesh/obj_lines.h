#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "opaline/scene.h"
#include "scene/formats.h"

namespace opaline::scene {

[[noreturn]] void failObj(const Input& input, const std::string& reason);

/// The file's text, without a byte-order mark.
std::string_view textOf(const Input& input);

struct ObjLine {
  std::string_view text;
  std::size_t size = 0;  ///< with the line break
};

/// Takes the next line off a text.
ObjLine nextLine(std::string_view& text);

/// Takes the next word off a line, empty at its end.
std::string_view nextWord(std::string_view& line);

/// The text with every line that ends in \ joined to the next. What stood between them becomes
/// spaces, so that everything else stays at its place. Comments are not continued, as they may end
/// in a folder's name. None where no line is continued.
std::optional<std::string> joinedLines(std::string_view text);

/// From `firstFace` on, faces are in this smoothing group. Faces of group 0 are flat.
struct ObjSmoothing {
  std::size_t firstFace = 0;
  std::uint32_t group = 0;
};

/// What the lines hold that tinyobjloader does not report.
struct ObjExtras {
  std::size_t coloredVertices = 0;
  std::vector<std::string> materialFiles;  ///< as each line names them, which may be several
  std::vector<NotShown> notShown;
  std::vector<ObjSmoothing> smoothing;  ///< empty where the file has no groups
};

/// Checks lines with numbers, since tinyobjloader reads what is not a number as 0, lets an index
/// overflow and stops at a zero byte. `text` is the file's text with its lines joined; messages
/// count the lines of the file itself.
ObjExtras requireSoundLines(const Input& input, std::string_view text);

}  // namespace opaline::scene
