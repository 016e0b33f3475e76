#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string_view>

namespace opaline::fuzz {

/// A folder of this process's own.
const std::filesystem::path& folder();

/// A file there.
std::filesystem::path fileOf(std::string_view name, std::string_view bytes);

/// What reads, or throws an Error that says why not.
void expectReadOrRefused(const std::function<void()>& read);

inline std::string_view textOf(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace opaline::fuzz
