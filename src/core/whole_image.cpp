#include <openexr.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "opaline/image_file.h"

namespace opaline {

namespace fs = std::filesystem;

namespace {

using namespace std::string_view_literals;

std::uint32_t bigEndian(const char* bytes) {
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value = value << 8U | static_cast<unsigned char>(bytes[i]);
  return value;
}

/// PNG specification, sections 5.2, 11.2.2 (IHDR) and 11.2.5 (IEND): the first and the last bytes.
bool isWholePng(const fs::path& file, int width, int height) {
  constexpr std::string_view start = "\x89PNG\r\n\x1a\n\0\0\0\rIHDR"sv;
  constexpr std::string_view end = "\0\0\0\0IEND\xae\x42\x60\x82"sv;
  std::ifstream stream(file, std::ios::binary);
  std::array<char, start.size() + 8> head{};
  std::array<char, end.size()> tail{};
  stream.read(head.data(), head.size());
  stream.seekg(-static_cast<std::streamoff>(tail.size()), std::ios::end);
  stream.read(tail.data(), tail.size());
  return stream && std::string_view(head.data(), start.size()) == start &&
         bigEndian(head.data() + start.size()) == static_cast<std::uint32_t>(width) &&
         bigEndian(head.data() + start.size() + 4) == static_cast<std::uint32_t>(height) &&
         std::string_view(tail.data(), tail.size()) == end;
}

/// A header read by OpenEXR's C interface. Closes the file at the end.
class ExrHeader {
 public:
  explicit ExrHeader(const fs::path& file) {
    exr_context_initializer_t options = EXR_DEFAULT_CONTEXT_INITIALIZER;
    options.flags = EXR_CONTEXT_FLAG_SILENT_HEADER_PARSE;
    options.error_handler_fn = [](exr_const_context_t, exr_result_t, const char*) {};
    open_ = exr_start_read(&context_, file.c_str(), &options) == EXR_ERR_SUCCESS;
  }
  ~ExrHeader() { exr_finish(&context_); }
  ExrHeader(const ExrHeader&) = delete;
  ExrHeader& operator=(const ExrHeader&) = delete;

  bool describes(int width, int height) const {
    exr_storage_t storage{};
    exr_attr_box2i_t window{};
    const exr_attr_chlist_t* channels = nullptr;
    constexpr int ours = 4;
    return open_ && exr_get_storage(context_, 0, &storage) == EXR_ERR_SUCCESS &&
           storage == EXR_STORAGE_SCANLINE &&
           exr_get_data_window(context_, 0, &window) == EXR_ERR_SUCCESS && window.min.x == 0 &&
           window.min.y == 0 && window.max.x == width - 1 && window.max.y == height - 1 &&
           exr_get_channels(context_, 0, &channels) == EXR_ERR_SUCCESS &&
           channels->num_channels == ours;
  }

  std::optional<std::string> note() const {
    std::int32_t length = 0;
    const char* text = nullptr;
    if (!open_ || exr_attr_get_string(context_, 0, "opaline", &length, &text) != EXR_ERR_SUCCESS) {
      return std::nullopt;
    }
    return std::string(text, static_cast<std::size_t>(length));
  }

  /// Whether the table of blocks is filled and every block lies inside the file.
  bool blocksFit(int height, std::uintmax_t fileBytes) const {
    std::int32_t lines = 0;
    if (exr_get_scanlines_per_chunk(context_, 0, &lines) != EXR_ERR_SUCCESS || lines < 1) {
      return false;
    }
    for (int y = 0; y < height; y += lines) {
      exr_chunk_info_t block{};
      if (exr_read_scanline_chunk_info(context_, 0, y, &block) != EXR_ERR_SUCCESS) return false;
      if (block.data_offset > fileBytes || block.packed_size > fileBytes - block.data_offset) {
        return false;
      }
    }
    return true;
  }

 private:
  exr_context_t context_ = nullptr;
  bool open_ = false;
};

bool isWholeExr(const fs::path& file, int width, int height, std::uintmax_t fileBytes) {
  const ExrHeader header(file);
  return header.describes(width, height) && header.blocksFit(height, fileBytes);
}

/// Looks only before the pixels, where the library writes its notes.
std::optional<std::string> noteOfPng(const fs::path& file) {
  constexpr std::string_view signature = "\x89PNG\r\n\x1a\n"sv;
  constexpr std::string_view keyword = "Opaline\0"sv;
  constexpr std::size_t longest = 1U << 20U;
  std::ifstream stream(file, std::ios::binary);
  std::array<char, signature.size()> start{};
  stream.read(start.data(), start.size());
  if (!stream || std::string_view(start.data(), start.size()) != signature) return std::nullopt;
  for (;;) {
    std::array<char, 8> head{};
    stream.read(head.data(), head.size());
    const std::size_t length = bigEndian(head.data());
    const std::string_view kind(head.data() + 4, 4);
    if (!stream || kind == "IDAT" || kind == "IEND") return std::nullopt;
    if (kind == "tEXt" && length >= keyword.size() && length <= longest) {
      std::string body(length, '\0');
      stream.read(body.data(), static_cast<std::streamsize>(length));
      if (stream && body.starts_with(keyword)) return body.substr(keyword.size());
      stream.seekg(4, std::ios::cur);
    } else {
      stream.seekg(static_cast<std::streamoff>(length) + 4, std::ios::cur);
    }
  }
}

bool isExr(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return extension == ".exr";
}

}  // namespace

std::optional<std::string> readImageNote(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return std::nullopt;
  return isExr(file) ? ExrHeader(file).note() : noteOfPng(file);
}

bool isWholeImage(const fs::path& file, int width, int height) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return false;
  const std::uintmax_t bytes = fs::file_size(file, error);
  if (error) return false;
  return isExr(file) ? isWholeExr(file, width, height, bytes) : isWholePng(file, width, height);
}

}  // namespace opaline
