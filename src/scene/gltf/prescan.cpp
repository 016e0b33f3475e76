#include "scene/gltf/prescan.h"

#include <fmt/format.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "opaline/error.h"
#include "scene/gltf/accepted_json.h"
#include "scene/gltf/extensions.h"
#include "scene/gltf/file.h"
#include "scene/text.h"

namespace opaline::scene {

namespace {

constexpr std::size_t deepestNesting = 200;
constexpr std::size_t mostValues = 4'000'000;
/// The largest extent that a file of readable size can hold.
constexpr std::uint64_t largestExtent = longestFileBytes;

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

std::string percentDecoded(std::string_view uri) {
  std::string decoded;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const int high = uri[i] == '%' && i + 2 < uri.size() ? hexDigit(uri[i + 1]) : -1;
    const int low = high >= 0 ? hexDigit(uri[i + 2]) : -1;
    if (low < 0) {
      decoded += uri[i];
    } else {
      decoded += static_cast<char>(16 * high + low);
      i += 2;
    }
  }
  return decoded;
}

namespace {

/// Follows the places root.buffers[i].uri; keeps nothing else.
class Scanner : public nlohmann::json_sax<nlohmann::json> {
 public:
  GltfPrescan found;
  std::string problem;
  bool isDamaged = false;  ///< and so no JSON

  std::size_t buffersWithoutUri() const { return embedded_; }
  const std::string& minVersion() const { return minVersion_; }

  bool null() override { return value(); }
  bool boolean(bool) override { return value(); }
  bool number_integer(number_integer_t number) override {
    if (number < 0 && isExtent()) {
      problem = fmt::format("'{}' of its data must not be negative", lastKey_);
    }
    return value();
  }
  bool number_unsigned(number_unsigned_t number) override {
    if (number > largestExtent && isExtent()) {
      problem = fmt::format("'{}' of its data is {}, but at most {} is possible", lastKey_, number,
                            largestExtent);
    }
    return value();
  }
  bool number_float(number_float_t, const string_t&) override { return value(); }
  bool binary(binary_t&) override { return value(); }
  bool string(string_t& text) override {
    if (depth_ == 2 && root_ == "extensionsRequired") found.extensionsRequired.push_back(text);
    if (depth_ == 2 && root_ == "extensionsUsed") found.extensionsUsed.push_back(text);
    if (depth_ == 2 && root_ == "asset" && lastKey_ == "minVersion") minVersion_ = text;
    if (inBuffer() && lastKey_ == "uri") {
      bufferHasUri_ = !text.empty();
      if (!text.starts_with("data:")) found.bufferFiles.insert(percentDecoded(text));
    }
    return value();
  }
  bool start_object(std::size_t) override {
    ++depth_;
    if (inBuffer()) bufferHasUri_ = false;
    return value();
  }
  bool key(string_t& name) override {
    if (depth_ == 1) {
      root_ = name.substr(0, 32);
      inBuffers_ = name == "buffers";
      inData_ = inBuffers_ || name == "bufferViews" || name == "accessors";
    }
    lastKey_ = name.substr(0, 16);
    return true;
  }
  bool end_object() override {
    if (inBuffer() && !bufferHasUri_) ++embedded_;
    --depth_;
    return true;
  }
  bool start_array(std::size_t) override {
    ++depth_;
    return value();
  }
  bool end_array() override {
    --depth_;
    return true;
  }
  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::json::exception&) override {
    problem = fmt::format("its JSON is damaged at byte {}", position);
    isDamaged = true;
    return false;
  }

 private:
  /// An object directly in root.buffers.
  bool inBuffer() const { return inBuffers_ && depth_ == 3; }

  /// Whether the number is one that tinygltf would take for 0, or cut to 32 bits, if it is too
  /// large.
  bool isExtent() const {
    return inData_ && (lastKey_ == "count" || lastKey_ == "byteOffset" ||
                       lastKey_ == "byteLength" || lastKey_ == "byteStride");
  }

  bool value() {
    if (depth_ > deepestNesting) {
      problem = fmt::format("its JSON is nested deeper than {} levels", deepestNesting);
    } else if (++values_ > mostValues) {
      problem = fmt::format("its JSON holds more than {} values", mostValues);
    }
    return problem.empty();
  }

  std::size_t depth_ = 0;
  std::size_t values_ = 0;
  std::size_t embedded_ = 0;
  bool inBuffers_ = false;
  bool inData_ = false;  ///< in root.buffers, root.bufferViews or root.accessors
  bool bufferHasUri_ = false;
  std::string root_;  ///< the key in the root below which everything lies
  std::string lastKey_;
  std::string minVersion_;
};

/// glTF 2.0, section 3.2.
void requireKnownVersion(const Input& input, const std::string& minVersion) {
  if (minVersion.empty() || minVersion == "2.0" || minVersion.starts_with("1.")) return;
  failGltf(input, fmt::format("it needs a reader of glTF version '{}', but this one reads 2.0",
                              cleanText(minVersion, 20)));
}

}  // namespace

GltfPrescan prescanGltf(const Input& input, std::string_view json, bool binary) {
  Scanner scanner;
  const bool whole = nlohmann::json::sax_parse(json.begin(), json.end(), &scanner);
  const std::size_t start = json.find_first_not_of(" \t\r\n");
  const bool isObject = start != std::string_view::npos && json[start] == '{';
  if ((scanner.isDamaged || whole) && !isObject) failGltf(input, "it is not a glTF file");
  if (!whole || !scanner.problem.empty()) {
    failGltf(input, scanner.problem.empty() ? "its JSON is damaged" : scanner.problem);
  }
  requireKnownVersion(input, scanner.minVersion());
  // The error of an unknown extension comes first, since it may explain what else looks damaged.
  requireKnownExtensions(input, scanner.found.extensionsRequired);
  if (scanner.buffersWithoutUri() > 0 && !binary && !mayHavePlaceholders(scanner.found)) {
    failGltf(input, "a buffer has no 'uri', which only a .glb file may leave out");
  }
  // tinygltf copies the binary chunk into each such buffer, unless it is a placeholder to be filled
  // later.
  if (scanner.buffersWithoutUri() > 1 && !mayHavePlaceholders(scanner.found)) {
    failGltf(input, "more than one buffer lacks a uri");
  }
  return std::move(scanner.found);
}

}  // namespace opaline::scene
