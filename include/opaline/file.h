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

/// The whole file. Throws Error, naming the file, when it does not exist, is not a regular file,
/// cannot be read or is longer than `limitBytes`. All of this is checked before memory is
/// allocated.
OPALINE_API std::vector<std::byte> readFile(const std::filesystem::path& file,
                                            std::size_t limitBytes);

/// The file's first `countBytes` bytes, or all if it is shorter. Throws like readFile().
OPALINE_API std::vector<std::byte> readFileHead(const std::filesystem::path& file,
                                                std::size_t countBytes);

/// What happens to a file that exists where another is to be written.
enum class Existing {
  Replace,       ///< it is overwritten
  Refuse,        ///< it stays, and writing throws Error
  TakeNextName,  ///< it stays, and the first free name of bear-2.png, bear-3.png, … is used
};

/// Where a file is to be written.
struct Target {
  std::filesystem::path path;
  Existing existing = Existing::Replace;

  Target(std::filesystem::path named, Existing then = Existing::Replace)
      : path(std::move(named)), existing(then) {}
};

/// The name itself or, if it is taken, the first free one of bear-2.png, bear-3.png, … Another
/// program may take that at any time.
OPALINE_API std::filesystem::path freeName(const std::filesystem::path& wanted);

/// Writes a temporary file beside the target and renames it, so that the target is never
/// incomplete. A file that is to stay is not replaced even if others write at the same time.
/// `write` gets the temporary name. Returns the path of the file. On failure throws Error, naming
/// the target, leaves nothing behind and keeps what existed before.
OPALINE_API std::filesystem::path writeWhole(
    const Target& target, const std::function<void(const std::filesystem::path& temporary)>& write);

/// The same for text or bytes that are at hand.
OPALINE_API std::filesystem::path writeWhole(const Target& target, std::string_view contents);

/// A file that is written bit by bit: it has another name beside the target, and takes the target's
/// place when keep() is called. Otherwise nothing is left behind, and what existed before stays.
class OPALINE_API WholeFile {
 public:
  /// Throws Error, naming the target, if it cannot be written.
  explicit WholeFile(const Target& target);
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  /// Where to write before keep().
  const std::filesystem::path& temporary() const;
  /// Gives the file its name and returns its path. Throws Error, naming the target.
  std::filesystem::path keep();
  /// Throws an Error that says why the target could not be written.
  [[noreturn]] void fail(std::string_view reason) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Throws Error when `target` could not be written, so that this is known before hours of work: its
/// folder does not exist, it is a folder, there is no permission, or an existing file has to stay.
OPALINE_API void requireWritable(const Target& target);

/// For a program that is about to die of a signal: removes the files that are being written and not
/// yet renamed. Any thread that creates or renames one from then on waits for ever. Call it from a
/// thread that waits for signals, not from a signal handler.
OPALINE_API void abandonTemporaryFiles();

}  // namespace opaline
