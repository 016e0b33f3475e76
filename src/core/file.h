#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

namespace opaline::core {

/// The whole file. Throws Error, naming it, when it does not exist, is no regular file, cannot be
/// read or is longer than `limitBytes`; nothing is allocated before that is known.
std::vector<std::byte> readFile(const std::filesystem::path& file, std::size_t limitBytes);

/// Its first `countBytes` bytes, or all where it is shorter. Throws like readFile.
std::vector<std::byte> readFileHead(const std::filesystem::path& file, std::size_t countBytes);

/// Writes beside the target and renames, so that a file that exists is whole. `write` gets the
/// temporary name. Throws Error, naming the target, and leaves nothing behind on failure; what
/// stood there before then stays.
void writeWhole(const std::filesystem::path& target,
                const std::function<void(const std::filesystem::path& temporary)>& write);

/// The same for text or bytes that stand ready.
void writeWhole(const std::filesystem::path& target, std::string_view contents);

/// A file that takes its time: it is written under another name beside the target, and takes its
/// place when it is kept. Otherwise nothing is left behind, and what stood there before stays.
class WholeFile {
 public:
  /// Throws Error, naming the target, where it cannot be written.
  explicit WholeFile(const std::filesystem::path& target);
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  const std::filesystem::path& temporary() const;
  /// Throws Error, naming the target.
  void keep();
  /// Throws the Error that it could not be written.
  [[noreturn]] void fail(std::string_view reason) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Throws Error now, before hours of work, when `target` could not be written: its folder does not
/// exist, it is a folder, or there is no permission.
void requireWritable(const std::filesystem::path& target);

/// For a program that is about to die of a signal: removes the files that are being written and not
/// yet renamed, and lets none be made or renamed from then on; whoever tries waits for ever. Not
/// for a signal handler but for a thread that waits for signals.
void abandonTemporaryFiles();

}  // namespace opaline::core
