#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>

#include "awkward_meshes.h"

namespace opaline::fuzz {

/// Takes numbers off the front of what a fuzzer made up; zeros where that has ended. So a change of
/// one byte changes one number.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : left_(data, size) {}

  bool ended() const { return left_.empty(); }

  template <typename T>
  T take() {
    T value{};
    const std::size_t bytes = std::min(sizeof(T), left_.size());
    if (bytes > 0) std::memcpy(&value, left_.data(), bytes);
    left_ = left_.subspan(bytes);
    return value;
  }

  std::uint32_t below(std::uint32_t limit) {
    return limit <= 256 ? take<std::uint8_t>() % limit : take<std::uint16_t>() % limit;
  }

  float finite() {
    const auto value = take<float>();
    return std::isfinite(value) ? value : 0;
  }

  /// Of any magnitude that a length in a scene has.
  float magnitude() { return std::exp2(static_cast<float>(static_cast<int>(below(64)) - 32)); }

  std::string_view rest() const {
    return {reinterpret_cast<const char*>(left_.data()), left_.size()};
  }

 private:
  std::span<const std::uint8_t> left_;
};

/// Any vertices and triangles, in up to four objects of which each has a triangle: on a small
/// lattice, as near to each other as floats can be, or anywhere.
awkward::Shape meshFrom(Input& input, std::size_t mostTriangles = 256);

/// The same as a scene's file may bring it: repaired and of finite size; without triangles where
/// nothing is left.
awkward::Shape repairedMeshFrom(Input& input);

}  // namespace opaline::fuzz
