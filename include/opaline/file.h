#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "opaline/export.h"

namespace opaline {

/// The whole file. Throws Error, naming it, when it does not exist, is no regular file, cannot be
/// read or is longer than `limitBytes`; nothing is allocated before that is known.
OPALINE_API std::vector<std::byte> readFile(const std::filesystem::path& file,
                                            std::size_t limitBytes);

/// Its first `countBytes` bytes, or all where it is shorter. Throws like readFile.
OPALINE_API std::vector<std::byte> readFileHead(const std::filesystem::path& file,
                                                std::size_t countBytes);

/// What becomes of a file that stands where another is to be written.
enum class Existing {
  Replace,       ///< it was named by who wants to write
  Refuse,        ///< it stays, and writing throws Error
  TakeNextName,  ///< it stays, and the first free one of bear-2.png, bear-3.png, … is taken
};

/// Where a file is to be written.
struct Target {
  std::filesystem::path path;
  Existing existing = Existing::Replace;

  Target(std::filesystem::path named, Existing then = Existing::Replace)
      : path(std::move(named)), existing(then) {}
};

/// The name itself, or where something stands there already, the first free one of bear-2.png,
/// bear-3.png, … Another program may take it at any time.
OPALINE_API std::filesystem::path freeName(const std::filesystem::path& wanted);

/// Writes beside the target and renames, so that a file that exists is whole; what stays is never
/// replaced, whoever else writes at the same time. `write` gets the temporary name. Returns where
/// the file is. Throws Error, naming the target, and leaves nothing behind on failure; what stood
/// there before then stays.
OPALINE_API std::filesystem::path writeWhole(
    const Target& target, const std::function<void(const std::filesystem::path& temporary)>& write);

/// The same for text or bytes that stand ready.
OPALINE_API std::filesystem::path writeWhole(const Target& target, std::string_view contents);

/// A file that takes its time: it is written under another name beside the target, and takes its
/// place when it is kept. Otherwise nothing is left behind, and what stood there before stays.
class OPALINE_API WholeFile {
 public:
  /// Throws Error, naming the target, where it cannot be written.
  explicit WholeFile(const Target& target);
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  /// Where to write until then.
  const std::filesystem::path& temporary() const;
  /// Returns where the file is. Throws Error, naming the target.
  std::filesystem::path keep();
  /// Throws the Error that it could not be written.
  [[noreturn]] void fail(std::string_view reason) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Throws Error now, before hours of work, when `target` could not be written: its folder does not
/// exist, it is a folder, there is no permission, or what stands there stays.
OPALINE_API void requireWritable(const Target& target);

/// For a program that is about to die of a signal: removes the files that are being written and not
/// yet renamed, and lets none be made or renamed from then on; whoever tries waits for ever. Not
/// for a signal handler but for a thread that waits for signals.
OPALINE_API void abandonTemporaryFiles();

}  // namespace opaline
