#include "opaline/scene_file.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string>
#include <string_view>

#include "opaline/error.h"
#include "opaline/file.h"
#include "scene/formats.h"
#include "scene/mesh/obj_lines.h"
#include "scene/text.h"

namespace opaline::scene {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t longestName = 4096;

/// RFC 3986, section 2.1.
std::string percentDecoded(std::string_view uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned byte = 0;
    const std::string_view digits = uri.substr(std::min(i + 1, uri.size()), 2);
    const auto [end, problem] =
        std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
    if (uri[i] == '%' && digits.size() == 2 && problem == std::errc() &&
        end == digits.data() + digits.size()) {
      text += static_cast<char>(byte);
      i += 2;
    } else {
      text += uri[i];
    }
  }
  return text;
}

/// The values of all "uri" in a glTF file's JSON, except data URIs.
void addUris(std::string_view text, const fs::path& folder, std::vector<fs::path>& to) {
  constexpr std::string_view key = "\"uri\"";
  for (std::size_t at = text.find(key); at != std::string_view::npos; at = text.find(key, at)) {
    at += key.size();
    const std::size_t open = text.find_first_not_of(" \t\r\n:", at);
    if (open == std::string_view::npos || text[open] != '"') continue;
    const std::string_view value = text.substr(open + 1, longestName);
    const std::size_t close = value.find('"');
    if (close == std::string_view::npos || value.starts_with("data:")) continue;
    to.push_back(folder / percentDecoded(value.substr(0, close)));
  }
}

/// For each line that begins with a keyword, its words, and the rest of the line without its first
/// words, for any number of them: there may be several names, options may precede one, and it may
/// contain blanks.
void addNamesBehind(std::string_view text, const fs::path& folder,
                    const std::vector<std::string_view>& keywords, std::vector<fs::path>& to) {
  constexpr int mostOptions = 40;
  while (!text.empty()) {
    const std::string_view line = trimmed(text.substr(0, text.find('\n')));
    text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    std::string keyword(line.substr(0, end));
    std::transform(keyword.begin(), keyword.end(), keyword.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const bool names = std::any_of(keywords.begin(), keywords.end(), [&](std::string_view start) {
      return keyword.starts_with(start);
    });
    const std::string_view rest = trimmed(line.substr(end));
    if (!names || rest.empty()) continue;
    std::string_view name = rest.substr(rest.size() - std::min(rest.size(), longestName));
    for (int option = 0; option < mostOptions && !name.empty(); ++option) {
      to.push_back(folder / name);
      const std::string_view word = nextWord(name);
      name = trimmed(name);
      if (!name.empty()) to.push_back(folder / word);
    }
  }
}

/// The text of a file, empty where it cannot be read.
std::string textOf(const fs::path& file) {
  try {
    const std::vector<std::byte> bytes = readFile(file, longestFileBytes);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  } catch (const Error&) {
    return {};
  }
}

void addModel(const fs::path& model, std::vector<fs::path>& to) {
  to.push_back(model);
  const fs::path folder = model.parent_path();
  const fs::path extension = model.extension();
  if (extension == ".ply" || extension == ".PLY") return;  // names no other files
  const std::string whole = textOf(model);
  const std::string_view text = withoutByteOrderMark(whole);
  addUris(text, folder, to);
  const std::size_t first = to.size();
  addNamesBehind(text, folder, {"mtllib"}, to);
  const std::vector<fs::path> libraries(to.begin() + static_cast<std::ptrdiff_t>(first), to.end());
  for (const fs::path& library : libraries) {
    addNamesBehind(textOf(library), library.parent_path(),
                   {"map_", "bump", "disp", "decal", "refl", "norm"}, to);
  }
}

}  // namespace

}  // namespace opaline::scene

namespace opaline {

std::vector<std::filesystem::path> filesOf(const SceneSource& source) {
  std::vector<std::filesystem::path> files;
  if (source.sceneFile) files.push_back(*source.sceneFile);
  for (const ModelSource& model : source.models) {
    if (!model.isBuiltIn()) scene::addModel(model.file, files);
    if (model.morphTo) scene::addModel(*model.morphTo, files);
  }
  if (source.environment) files.push_back(source.environment->file);
  return files;
}

}  // namespace opaline
