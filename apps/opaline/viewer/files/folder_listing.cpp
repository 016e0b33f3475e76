#include "viewer/files/folder_listing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "cli/paths.h"

namespace opaline::app::viewer {

namespace fs = std::filesystem;

namespace {

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

// Sorts names as people do: without regard to case, and m_9 before m_10.
bool comesBefore(const std::string& a, const std::string& b) {
  std::size_t i = 0;
  std::size_t j = 0;
  const auto number = [](const std::string& text, std::size_t& at) {
    while (at < text.size() && text[at] == '0') ++at;
    const std::size_t begin = at;
    while (at < text.size() && isDigit(text[at])) ++at;
    return std::string_view(text).substr(begin, at - begin);
  };
  while (i < a.size() && j < b.size()) {
    if (isDigit(a[i]) && isDigit(b[j])) {
      const std::string_view x = number(a, i);
      const std::string_view y = number(b, j);
      if (x.size() != y.size()) return x.size() < y.size();
      if (x != y) return x < y;
      continue;
    }
    const auto x = static_cast<unsigned char>(lower(a[i++]));
    const auto y = static_cast<unsigned char>(lower(b[j++]));
    if (x != y) return x < y;
  }
  if (a.size() - i != b.size() - j) return a.size() - i < b.size() - j;
  return a < b;
}

// The length of the character that begins there; 0 where none does (RFC 3629).
std::size_t characterBytes(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const unsigned first = byte(at);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xC2 && first < 0xE0   ? 2
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xC0U) != 0x80) return 0;
  }
  const unsigned second = byte(at + 1);
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool surrogate = first == 0xED && second >= 0xA0;
  const bool beyond = first == 0xF4 && second >= 0x90;
  return overlong || surrogate || beyond ? 0 : length;
}

}  // namespace

bool isFolder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

std::string shownName(const fs::path& name) {
  const std::string& bytes = name.native();
  std::string shown;
  for (std::size_t i = 0; i < bytes.size();) {
    const std::size_t count = characterBytes(bytes, i);
    const auto first = static_cast<unsigned char>(bytes[i]);
    const bool control = first < 0x20 || first == 0x7F;
    if (count == 0 || control) {
      shown += '?';
    } else {
      shown.append(bytes, i, count);
    }
    i += std::max<std::size_t>(count, 1);
  }
  return shown;
}

FolderListing listFolder(const fs::path& folder, const std::vector<std::string>& extensions,
                         bool hidden) {
  FolderListing listing;
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    fs::path name = entry->path().filename();
    if (!hidden && name.native().starts_with('.')) continue;
    std::error_code unknown;  // a dangling link is not a folder
    const bool isFolder = entry->is_directory(unknown);
    const bool wanted =
        isFolder || extensions.empty() ||
        std::find(extensions.begin(), extensions.end(), extensionOf(name)) != extensions.end();
    if (!wanted) continue;
    std::string text = shownName(name);
    listing.entries.push_back({std::move(name), std::move(text), isFolder});
  }
  if (error) {
    listing.error = fmt::format("{} cannot be read: {}", shownName(folder), error.message());
  }
  std::sort(listing.entries.begin(), listing.entries.end(),
            [](const FolderEntry& a, const FolderEntry& b) {
              if (a.isFolder != b.isFolder) return a.isFolder;
              return comesBefore(a.name.native(), b.name.native());
            });
  return listing;
}

std::optional<std::size_t> firstWith(const FolderListing& listing, std::string_view text) {
  if (text.empty()) return std::nullopt;
  const auto begins = [&](const FolderEntry& entry) {
    return entry.text.size() >= text.size() &&
           std::equal(text.begin(), text.end(), entry.text.begin(),
                      [](char a, char b) { return lower(a) == lower(b); });
  };
  const auto found = std::find_if(listing.entries.begin(), listing.entries.end(), begins);
  if (found == listing.entries.end()) return std::nullopt;
  return static_cast<std::size_t>(found - listing.entries.begin());
}

fs::path homeFolder() {
  const char* const home = std::getenv("HOME");
  return home != nullptr && *home == '/' ? home : "/";
}

fs::path typedPath(const fs::path& folder, std::string_view typed) {
  fs::path path = typed;
  if (typed == "~") path = homeFolder();
  if (typed.starts_with("~/")) path = homeFolder() / typed.substr(2);
  fs::path whole = (folder / path).lexically_normal();
  // "models/" means the folder models, not an unnamed file in it.
  return whole.has_filename() || !whole.has_relative_path() ? whole : whole.parent_path();
}

}  // namespace opaline::app::viewer
