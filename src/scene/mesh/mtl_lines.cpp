#include "scene/mesh/mtl_lines.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <utility>
#include <vector>

#include "scene/mesh/obj_lines.h"
#include "scene/text.h"

// The format: Alias|Wavefront, "MTL Material Format (Lightwave, OBJ)", 1995.

namespace opaline::scene {

namespace {

enum class MtlUse {
  Name,
  Read,
  Texture,  ///< read, but not all of its options
  AmbientTexture,
  Filter,
  Illumination,
  Amount,  ///< not shown unless it is 0
  NotShown,
  Nothing,  ///< by itself it changes no picture
};

struct MtlKey {
  std::string_view name;
  MtlUse use;
};

/// Exporters write Ka, Ni, illum, Pcr and the like into every file. Ambient light is that of the
/// scene. Ni only matters to refraction, which illum asks for, since Ks says what is mirrored.
constexpr std::array<MtlKey, 33> mtlKeys{{
    {"newmtl", MtlUse::Name},
    {"Kd", MtlUse::Read},
    {"Ks", MtlUse::Read},
    {"Ke", MtlUse::Read},
    {"Ns", MtlUse::Read},
    {"d", MtlUse::Read},
    {"Tr", MtlUse::Read},
    {"Pr", MtlUse::Read},
    {"Pm", MtlUse::Read},
    {"map_Kd", MtlUse::Texture},
    {"map_Ke", MtlUse::Texture},
    {"norm", MtlUse::Texture},
    {"Tf", MtlUse::Filter},
    {"Kt", MtlUse::Filter},
    {"illum", MtlUse::Illumination},
    {"Ps", MtlUse::Amount},
    {"Pc", MtlUse::Amount},
    {"aniso", MtlUse::Amount},
    {"map_Ka", MtlUse::AmbientTexture},
    {"map_Ks", MtlUse::NotShown},
    {"map_Ns", MtlUse::NotShown},
    {"map_d", MtlUse::NotShown},
    {"map_Bump", MtlUse::NotShown},
    {"bump", MtlUse::NotShown},
    {"disp", MtlUse::NotShown},
    {"decal", MtlUse::NotShown},
    {"refl", MtlUse::NotShown},
    {"map_aat", MtlUse::Nothing},
    {"Ka", MtlUse::Nothing},
    {"Ni", MtlUse::Nothing},
    {"Pcr", MtlUse::Nothing},
    {"anisor", MtlUse::Nothing},
    {"sharpness", MtlUse::Nothing},
}};

/// An option of a texture, with the values that change nothing.
struct TextureOption {
  std::string_view name;
  std::size_t mostNumbers = 0;  ///< 0: a word follows
  std::array<double, 3> neutral{};
  std::string_view neutralWord{};
};

constexpr std::array<TextureOption, 13> textureOptions{{
    {"-s", 3, {1, 1, 1}},
    {"-o", 3},
    {"-t", 3},
    {"-mm", 2, {0, 1, 0}},
    {"-bm", 1, {1, 0, 0}},
    {"-blendu", 0, {}, "on"},
    {"-blendv", 0, {}, "on"},
    {"-cc", 0, {}, "off"},
    {"-boost"},
    {"-colorspace"},
    {"-imfchan"},
    {"-texres"},
    {"-type"},
}};

bool equalButForCase(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) ==
           std::tolower(static_cast<unsigned char>(y));
  });
}

MtlKey mtlKey(std::string_view word) {
  for (const MtlKey& key : mtlKeys)
    if (equalButForCase(key.name, word)) return key;
  return {word, MtlUse::NotShown};
}

const TextureOption* textureOption(std::string_view word) {
  const auto found = std::find_if(textureOptions.begin(), textureOptions.end(),
                                  [&](const TextureOption& of) { return of.name == word; });
  return found == textureOptions.end() ? nullptr : &*found;
}

/// Takes numbers off a line, at most so many.
std::vector<double> takeNumbers(std::string_view& line, std::size_t most) {
  std::vector<double> numbers;
  while (numbers.size() < most) {
    std::string_view rest = line;
    std::string_view word = nextWord(rest);
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    const char* end = word.data() + word.size();
    const auto [stop, problem] = std::from_chars(word.data(), end, value);
    if (word.empty() || problem != std::errc{} || stop != end) break;
    numbers.push_back(value);
    line = rest;
  }
  return numbers;
}

/// Takes the values of an option off a line. Returns whether they change nothing.
bool takeNeutral(const TextureOption& option, std::string_view& line) {
  if (option.mostNumbers == 0) return nextWord(line) == option.neutralWord;
  const std::vector<double> numbers = takeNumbers(line, option.mostNumbers);
  return std::equal(numbers.begin(), numbers.end(), option.neutral.begin());
}

/// Whether light passes unchanged through a filter of these components, or not at all. Fewer than
/// three mean grey.
bool isClearOrOpaque(const std::vector<double>& filter) {
  return filter.empty() ||
         ((filter[0] == 0 || filter[0] == 1) &&
          std::all_of(filter.begin(), filter.end(), [&](double of) { return of == filter[0]; }));
}

class MtlLineReader {
 public:
  void read(std::string_view line) {
    const std::string_view word = nextWord(line);
    if (word.empty() || word.starts_with('#')) return;
    const MtlKey key = mtlKey(word);
    const std::string_view value = trimmed(line);
    switch (key.use) {
      case MtlUse::Name:
        endMaterial();
        material_ = value;
        write(key, value);
        return;
      case MtlUse::Read:
        readNumbers(key, value);
        return;
      case MtlUse::Texture:
        if (key.name == "map_Kd") colorTexture_ = value;
        write(key, withoutOptions(key, value));
        return;
      case MtlUse::AmbientTexture:
        ambientTexture_ = value;
        return;
      case MtlUse::Filter:
        if (!isClearOrOpaque(takeNumbers(line, 3))) leaveOut(key.name);
        return;
      case MtlUse::Illumination:
        readIllumination(line);
        return;
      case MtlUse::Amount:
        if (takeNumbers(line, 1) != std::vector<double>{0}) leaveOut(key.name);
        return;
      case MtlUse::NotShown:
        leaveOut(key.name);
        return;
      case MtlUse::Nothing:
        return;
    }
  }

  MtlLines take() {
    endMaterial();
    return std::move(lines_);
  }

 private:
  void leaveOut(std::string_view what) { lines_.notShown[material_].insert(cleanText(what, 40)); }

  void write(const MtlKey& key, std::string_view value) {
    lines_.text += key.name;
    lines_.text += ' ';
    lines_.text += value;
    lines_.text += '\n';
  }

  void readNumbers(const MtlKey& key, std::string_view value) {
    write(key, value);
    const std::string_view word = nextWord(value);
    if (word == "spectral" || word == "xyz")
      leaveOut(std::string(key.name) + " " + std::string(word));
  }

  /// What is mirrored is shown for all numbers, and glass (4 and 9) is not clear unless d or Tf say
  /// so.
  void readIllumination(std::string_view line) {
    const std::vector<double> model = takeNumbers(line, 1);
    if (!model.empty() && (model[0] == 6 || model[0] == 7)) leaveOut("refraction");
  }

  /// The name of a texture, with no option before it but -clamp.
  std::string withoutOptions(const MtlKey& key, std::string_view value) {
    std::string kept;
    while (true) {
      std::string_view rest = value;
      const std::string_view word = nextWord(rest);
      const TextureOption* const option = textureOption(word);
      if (word == "-clamp") {
        kept += "-clamp " + std::string(nextWord(rest)) + " ";
      } else if (option == nullptr) {
        return kept += trimmed(value);
      } else if (!takeNeutral(*option, rest)) {
        leaveOut(std::string(option->name) + " of " + std::string(key.name));
      }
      value = rest;
    }
  }

  /// Exporters repeat the colour's texture for ambient light.
  void endMaterial() {
    if (!ambientTexture_.empty() && ambientTexture_ != colorTexture_) leaveOut("map_Ka");
    ambientTexture_ = colorTexture_ = {};
  }

  MtlLines lines_;
  std::string material_;
  std::string_view colorTexture_;
  std::string_view ambientTexture_;
};

}  // namespace

MtlLines mtlLines(std::string_view text) {
  MtlLineReader reader;
  for (text = withoutByteOrderMark(text); !text.empty();) reader.read(nextLine(text).text);
  return reader.take();
}

}  // namespace opaline::scene
