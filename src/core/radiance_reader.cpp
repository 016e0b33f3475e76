// Radiance RGBE, after the description of the format in "Real Pixels" (Ward 1991) and the Radiance
// file formats. stb_image reads it too, but takes a file that ends early for a whole one.

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

#include "core/hdr_readers.h"

namespace opaline::core {

namespace {

using Rgbe = std::array<std::uint8_t, 4>;

class Decoder {
 public:
  Decoder(const std::filesystem::path& file, std::span<const std::byte> bytes)
      : file_(file), bytes_(bytes) {}

  Image decode() {
    const std::size_t fileBytes = bytes_.size();
    readHeader();
    readResolution();
    constexpr int exponentBias = 128 + 8;
    for (int exponent = 1; exponent < 256; ++exponent)
      units_[static_cast<std::size_t>(exponent)] = std::ldexp(scale_, exponent - exponentBias);
    RowCollector rows(file_, width_, height_, fileBytes, Negatives::BecomeZero);
    std::vector<Rgbe> row(static_cast<std::size_t>(width_));
    std::vector<float> rgba(4 * row.size());
    for (int y = 0; y < height_; ++y) {
      readRow(row);
      toFloat(row, rgba);
      rows.append(rgba);
    }
    return rows.take();
  }

 private:
  [[noreturn]] void fail(std::string_view reason) const { failToReadImage(file_, reason); }

  std::uint8_t nextByte() {
    if (bytes_.empty()) fail("it ends before its last pixel");
    const auto value = std::to_integer<std::uint8_t>(bytes_.front());
    bytes_ = bytes_.subspan(1);
    return value;
  }

  std::string nextLine() {
    constexpr std::size_t longestLine = 4096;
    std::string line;
    while (line.size() < longestLine) {
      const char character = static_cast<char>(nextByte());
      if (character == '\n') return line;
      line += character;
    }
    fail("its header has a line without end");
  }

  void readHeader() {
    bool first = true;
    for (std::string line = nextLine(); !line.empty(); line = nextLine()) {
      if (std::exchange(first, false)) continue;  // the magic word and a program's name
      if (line.starts_with("FORMAT=")) {
        if (line != "FORMAT=32-bit_rle_rgbe") fail("its format is not 32-bit_rle_rgbe");
      } else if (line.starts_with("EXPOSURE=")) {
        divideByExposure(std::string_view(line).substr(9));
      }
    }
  }

  /// Pixels have been multiplied by all the exposures that the header names.
  void divideByExposure(std::string_view text) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    double exposure = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), exposure);
    if (error != std::errc() || !std::isfinite(exposure) || exposure <= 0) {
      fail("its exposure is not a positive number");
    }
    scale_ /= exposure;
  }

  void readResolution() {
    const std::string line = nextLine();
    const auto bad = [&] {
      fail("its pixels are not in rows from the top left (-Y height +X width); convert it");
    };
    std::string_view rest = line;
    const auto number = [&](std::string_view prefix) {
      if (!rest.starts_with(prefix)) bad();
      rest.remove_prefix(prefix.size());
      long long value = 0;
      const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
      if (error != std::errc()) bad();
      rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
      return value;
    };
    const long long height = number("-Y ");
    const long long width = number(" +X ");
    if (!rest.empty()) bad();
    requireImageSize(file_, width, height);
    width_ = static_cast<int>(width);
    height_ = static_cast<int>(height);
  }

  void readRow(std::vector<Rgbe>& row) {
    const Rgbe first = nextPixel();
    const bool separateRuns = first[0] == 2 && first[1] == 2 && first[2] < 128;
    if (separateRuns && row.size() >= 8 && row.size() < 32768) {
      if ((first[2] << 8 | first[3]) != width_) fail("a row of pixels has another width");
      for (std::size_t channel = 0; channel < 4; ++channel) readChannel(row, channel);
    } else {
      readFlatRow(row, first);
    }
  }

  Rgbe nextPixel() {
    Rgbe pixel{};
    for (std::uint8_t& value : pixel) value = nextByte();
    return pixel;
  }

  void readChannel(std::vector<Rgbe>& row, std::size_t channel) {
    for (std::size_t x = 0; x < row.size();) {
      const std::uint8_t code = nextByte();
      const bool isRun = code > 128;
      const std::size_t count = isRun ? code - 128U : code;
      if (count == 0 || count > row.size() - x) fail("a run of pixels is longer than its row");
      const std::size_t end = x + count;
      if (isRun) {
        const std::uint8_t value = nextByte();
        for (; x < end; ++x) row[x][channel] = value;
      } else {
        for (; x < end; ++x) row[x][channel] = nextByte();
      }
    }
  }

  /// Plain pixels, among which (1, 1, 1, n) repeats the last one; successive repeats count in
  /// higher bytes.
  void readFlatRow(std::vector<Rgbe>& row, Rgbe pixel) {
    unsigned shift = 0;
    for (std::size_t x = 0;;) {
      if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) {
        if (x == 0 || shift > 16) fail("a run of pixels repeats none, or too many");
        const std::size_t count = std::size_t{pixel[3]} << shift;
        if (count > row.size() - x) fail("a run of pixels is longer than its row");
        for (std::size_t i = 0; i < count; ++i, ++x) row[x] = row[x - 1];
        shift += 8;
      } else {
        row[x++] = pixel;
        shift = 0;
      }
      if (x == row.size()) return;
      pixel = nextPixel();
    }
  }

  void toFloat(const std::vector<Rgbe>& row, std::vector<float>& rgba) const {
    float* out = rgba.data();
    for (const Rgbe& pixel : row) {
      const double unit = units_[pixel[3]];
      for (std::size_t c = 0; c < 3; ++c) *out++ = static_cast<float>(pixel[c] * unit);
      *out++ = 1.0F;
    }
  }

  std::filesystem::path file_;
  std::span<const std::byte> bytes_;
  double scale_ = 1;
  std::array<double, 256> units_{};  // of a mantissa, by exponent
  int width_ = 0;
  int height_ = 0;
};

}  // namespace

Image readRadiance(const std::filesystem::path& file, std::span<const std::byte> bytes) {
  return Decoder(file, bytes).decode();
}

}  // namespace opaline::core
