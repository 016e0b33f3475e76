#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace opaline::core {

/// FNV-1a of 64 bits (Fowler, Noll and Vo 1991) of all that is added. It reveals accidental
/// changes, but no forgery.
class Digest {
 public:
  void addBytes(const void* data, std::size_t bytes) {
    const auto* byte = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < bytes; ++i) value_ = (value_ ^ byte[i]) * 0x100000001B3U;
  }
  /// For types without padding bytes.
  template <typename T>
  requires std::is_trivially_copyable_v<T>
  void add(const T& value) { addBytes(&value, sizeof(value)); }
  /// The length is added too, so that two lists differ from their concatenation.
  template <typename T>
  requires std::is_trivially_copyable_v<T>
  void add(const std::vector<T>& values) {
    add(std::uint64_t{values.size()});
    addBytes(values.data(), values.size() * sizeof(T));
  }

  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xCBF29CE484222325U;
};

}  // namespace opaline::core
