#include "opaline/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <mutex>
#include <set>
#include <string>
#include <system_error>

#include "opaline/error.h"
#include "opaline/types.h"

namespace opaline {

namespace fs = std::filesystem;

namespace {

std::string reasonOf(int errorNumber) {
  return std::generic_category().message(errorNumber);
}

[[noreturn]] void failToRead(const fs::path& file, std::string_view reason) {
  throw Error(fmt::format("Cannot read {}: {}.", file.string(), reason));
}

[[noreturn]] void failToWrite(const fs::path& file, std::string_view reason) {
  throw Error(fmt::format("Cannot write {}: {}.", file.string(), reason));
}

fs::path folderOf(const fs::path& target) {
  return target.has_parent_path() ? target.parent_path() : fs::path(".");
}

std::uintmax_t sizeOfRegular(const fs::path& file) {
  if (file.empty()) throw Error("Cannot read a file without a name.");
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status)) {
    failToRead(file, status.type() == fs::file_type::not_found ? "there is no such file"
                                                               : error.message());
  }
  if (fs::is_directory(status)) failToRead(file, "it is a folder");
  if (!fs::is_regular_file(status)) failToRead(file, "it is not a regular file");
  const std::uintmax_t size = fs::file_size(file, error);
  if (error) failToRead(file, error.message());
  return size;
}

std::ifstream opened(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) failToRead(file, reasonOf(errno));
  return stream;
}

void readExactly(std::ifstream& stream, const fs::path& file, std::vector<std::byte>& bytes) {
  const auto count = static_cast<std::streamsize>(bytes.size());
  stream.read(reinterpret_cast<char*>(bytes.data()), count);
  if (stream.gcount() != count) failToRead(file, "it ended early or the disk failed");
}

/// Follows a symbolic link, so that its target is replaced, not the link.
fs::path resolved(const fs::path& target) {
  std::error_code error;
  if (!fs::is_symlink(target, error)) return target;
  fs::path real = fs::canonical(target, error);
  if (error) failToWrite(target, "it is a symbolic link to nothing");
  return real;
}

[[noreturn]] void failAsItStands(const fs::path& target) {
  failToWrite(target, "a file of that name is there already");
}

bool somethingStandsAt(const fs::path& path) {
  std::error_code error;
  const fs::file_type type = fs::symlink_status(path, error).type();
  return type != fs::file_type::not_found && type != fs::file_type::none;
}

void requireFolder(const fs::path& target) {
  if (target.empty()) throw Error("Cannot write a file without a name.");
  std::error_code error;
  const fs::path folder = folderOf(target);
  const fs::file_status folderStatus = fs::status(folder, error);
  if (!fs::exists(folderStatus)) {
    failToWrite(target, folderStatus.type() == fs::file_type::not_found
                            ? fmt::format("the folder {} does not exist", folder.string())
                            : error.message());
  }
  if (!fs::is_directory(folderStatus)) {
    failToWrite(target, fmt::format("{} is not a folder", folder.string()));
  }
}

/// The file that will be replaced or created. Throws Error if that is bound to fail.
fs::path replaceable(const fs::path& target) {
  requireFolder(target);
  std::error_code error;
  const fs::file_status status = fs::status(target, error);
  if (status.type() == fs::file_type::none) failToWrite(target, error.message());
  if (!target.has_filename() || fs::is_directory(status)) failToWrite(target, "it is a folder");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    failToWrite(target, "it is not a regular file");
  }
  fs::path real = resolved(target);
  if (fs::exists(status) && access(real.c_str(), W_OK) != 0) failToWrite(target, reasonOf(errno));
  return real;
}

/// The path beside which the temporary file is made. Throws Error if writing is bound to fail.
fs::path checkedTarget(const Target& target) {
  if (!isUpTo(Existing::TakeNextName, target.existing))
    failToWrite(target.path, "what happens to a file of that name is none of what can happen");
  if (target.existing == Existing::Replace) return replaceable(target.path);
  requireFolder(target.path);
  if (target.existing == Existing::Refuse && somethingStandsAt(target.path)) {
    failAsItStands(target.path);
  }
  return target.path;
}

/// All temporary files of this process. They are made, renamed and removed under the lock, so that
/// its holder knows all of them.
struct TemporaryFiles {
  std::mutex mutex;
  std::set<fs::path> paths;
  std::set<fs::path> cleared;  ///< folders whose abandoned files were removed
};

TemporaryFiles& temporaryFiles() {
  // Never destroyed: a thread may wait for a signal until the very end.
  static TemporaryFiles& files = *new TemporaryFiles;
  return files;
}

constexpr std::string_view temporaryStart = ".opaline-";

/// A temporary file is locked by its maker for as long as it exists. So an unlocked one was left by
/// a program that was killed.
void removeIfLeft(const fs::path& file) {
  const int descriptor = open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return;
  if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) unlink(file.c_str());
  close(descriptor);
}

/// .opaline-PROCESS-NUMBER, and an extension.
bool isTemporaryName(std::string_view name) {
  const auto skipDigits = [&name] {
    const std::size_t end = name.find_first_not_of("0123456789");
    const bool some = end != 0 && !name.empty();
    name.remove_prefix(std::min(end, name.size()));
    return some;
  };
  if (!name.starts_with(temporaryStart)) return false;
  name.remove_prefix(temporaryStart.size());
  if (!skipDigits() || !name.starts_with('-')) return false;
  name.remove_prefix(1);
  return skipDigits() && (name.empty() || name.front() == '.');
}

void removeWhatIsLeftIn(const fs::path& folder) {
  std::error_code ignored;  // files that stay do no harm
  for (fs::directory_iterator entry(folder, ignored), end; !ignored && entry != end;
       entry.increment(ignored)) {
    if (isTemporaryName(entry->path().filename().string()) &&
        fs::is_regular_file(entry->symlink_status(ignored)))
      removeIfLeft(entry->path());
  }
}

/// Removes the temporary file unless it has been renamed.
class TemporaryFile {
 public:
  /// Creates an empty file beside `target` that was not there before, with the same extension:
  /// some writers choose the format by it. The first in a folder removes those that killed programs
  /// left there.
  explicit TemporaryFile(const fs::path& target) {
    constexpr std::size_t longestExtension = 16;
    std::string extension = target.extension().string();
    if (extension.size() > longestExtension) extension.clear();
    const fs::path folder = folderOf(target);
    const std::lock_guard lock(temporaryFiles().mutex);
    if (temporaryFiles().cleared.insert(folder).second) removeWhatIsLeftIn(folder);
    while (!create(folder, extension)) {
      if (errno != EEXIST) failToWrite(target, reasonOf(errno));
    }
    temporaryFiles().paths.insert(path_);
  }
  ~TemporaryFile() {
    if (path_.empty()) return;
    const std::lock_guard lock(temporaryFiles().mutex);
    std::error_code ignored;  // nothing better can be done about a file that cannot be removed
    fs::remove(path_, ignored);
    temporaryFiles().paths.erase(path_);
    close(descriptor_);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const fs::path& path() const { return path_; }

  void renameTo(const fs::path& target) {
    std::error_code error;
    const fs::file_status old = fs::status(target, error);
    if (!error && fs::exists(old)) fs::permissions(path_, old.permissions(), error);
    const std::lock_guard lock(temporaryFiles().mutex);
    fs::rename(path_, target, error);
    if (error) failToWrite(target, error.message());
    forget();
  }

  /// False if the target exists; it then stays.
  bool renameUnlessTaken(const fs::path& target) {
    const std::lock_guard lock(temporaryFiles().mutex);
    if (renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, target.c_str(), RENAME_NOREPLACE) != 0) {
      if (errno == EEXIST) return false;
      if (errno != EINVAL && errno != ENOSYS) failToWrite(target, reasonOf(errno));
      return claimAndRename(target);
    }
    forget();
    return true;
  }

 private:
  /// False, with a reason in errno, if the name is taken, or if another program removed the new
  /// file as abandoned before it was locked.
  bool create(const fs::path& folder, const std::string& extension) {
    static std::atomic<unsigned> counter = 0;
    path_ = folder / fmt::format("{}{}-{}{}", temporaryStart, getpid(), counter++, extension);
    descriptor_ = open(path_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (descriptor_ < 0) return false;
    struct stat status {};
    // On a file system without locks, nobody removes abandoned files either.
    if (flock(descriptor_, LOCK_EX) != 0 || fstat(descriptor_, &status) != 0 || status.st_nlink > 0)
      return true;
    close(descriptor_);
    errno = EEXIST;
    return false;
  }

  /// For file systems that cannot refuse to replace: the name is first taken by an empty file.
  bool claimAndRename(const fs::path& target) {
    const int claimed = open(target.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (claimed < 0 && errno == EEXIST) return false;
    if (claimed < 0) failToWrite(target, reasonOf(errno));
    close(claimed);
    std::error_code error;
    fs::rename(path_, target, error);
    if (error) {
      unlink(target.c_str());
      failToWrite(target, error.message());
    }
    forget();
    return true;
  }

  void forget() {
    temporaryFiles().paths.erase(path_);
    path_.clear();
    close(descriptor_);
  }

  fs::path path_;
  int descriptor_ = -1;
};

}  // namespace

std::vector<std::byte> readFile(const fs::path& file, std::size_t limitBytes) {
  const std::uintmax_t size = sizeOfRegular(file);
  if (size > limitBytes) {
    failToRead(file, fmt::format("it has {} bytes and at most {} are accepted", size, limitBytes));
  }
  std::ifstream stream = opened(file);
  std::vector<std::byte> bytes(static_cast<std::size_t>(size));
  readExactly(stream, file, bytes);
  if (stream.peek() != std::ifstream::traits_type::eof()) {
    failToRead(file, "its length changed while it was read");
  }
  return bytes;
}

std::vector<std::byte> readFileHead(const fs::path& file, std::size_t countBytes) {
  const std::uintmax_t size = sizeOfRegular(file);
  std::ifstream stream = opened(file);
  std::vector<std::byte> bytes(
      static_cast<std::size_t>(std::min<std::uintmax_t>(size, countBytes)));
  readExactly(stream, file, bytes);
  return bytes;
}

fs::path freeName(const fs::path& wanted) {
  fs::path name = wanted;
  for (int number = 2; somethingStandsAt(name); ++number) {
    name = wanted.parent_path() /
           fmt::format("{}-{}{}", wanted.stem().string(), number, wanted.extension().string());
  }
  return name;
}

void requireWritable(const Target& target) {
  // Only trying shows whether permissions and the file system allow it.
  const TemporaryFile probe(checkedTarget(target));
}

struct WholeFile::State {
  explicit State(const Target& wanted) : target(wanted), real(checkedTarget(wanted)), file(real) {}

  Target target;  ///< as it was given, for messages
  fs::path real;
  TemporaryFile file;
};

WholeFile::WholeFile(const Target& target) : state_(std::make_unique<State>(target)) {}

WholeFile::~WholeFile() = default;

const fs::path& WholeFile::temporary() const {
  return state_->file.path();
}

fs::path WholeFile::keep() {
  std::error_code error;
  if (!fs::is_regular_file(temporary(), error)) fail("nothing was written");
  const fs::path& wanted = state_->target.path;
  switch (state_->target.existing) {
    case Existing::Replace:
      state_->file.renameTo(state_->real);
      break;
    case Existing::Refuse:
      if (!state_->file.renameUnlessTaken(wanted)) failAsItStands(wanted);
      break;
    case Existing::TakeNextName:
      for (;;) {
        fs::path name = freeName(wanted);
        if (state_->file.renameUnlessTaken(name)) return name;
      }
  }
  return wanted;
}

void WholeFile::fail(std::string_view reason) const {
  failToWrite(state_->target.path, reason);
}

fs::path writeWhole(const Target& target, const std::function<void(const fs::path&)>& write) {
  WholeFile file(target);
  try {
    write(file.temporary());
  } catch (const Error&) {
    throw;
  } catch (const std::exception& failure) {
    file.fail(failure.what());
  }
  return file.keep();
}

fs::path writeWhole(const Target& target, std::string_view contents) {
  return writeWhole(target, [&](const fs::path& temporary) {
    std::ofstream stream(temporary, std::ios::binary | std::ios::trunc);
    stream.write(contents.data(), static_cast<std::streamsize>(contents.size()));
    stream.close();
    if (!stream) failToWrite(target.path, reasonOf(errno != 0 ? errno : EIO));
  });
}

void abandonTemporaryFiles() {
  temporaryFiles().mutex.lock();  // never unlocked
  for (const fs::path& path : temporaryFiles().paths) unlink(path.c_str());
}

}  // namespace opaline
