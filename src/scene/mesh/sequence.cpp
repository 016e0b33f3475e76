#include "opaline/sequence.h"

#include <fmt/format.h>

#include <new>
#include <utility>

#include "opaline/error.h"
#include "opaline/numbered_name.h"
#include "scene/finish.h"
#include "scene/mesh/sequence_state.h"
#include "scene/text.h"

namespace opaline {

namespace {

MeshSequence::State load(const std::filesystem::path& pattern, const LoadOptions& options) {
  scene::requireSensible(options);
  scene::MeshFiles files(pattern, options.morphTo);
  const std::filesystem::path first = files.file(files.first());
  try {
    std::vector<Repair> repairs;
    scene::RawScene raw = scene::inMillimetres(files.loadFirst(options.log), first,
                                               !options.diagonalMm, options.log, repairs);
    files.followRepairs(raw);
    Scene made = scene::finished(std::move(raw), first, std::move(repairs), options);
    files.followPlace(made);
    return {std::move(files), std::move(made)};
  } catch (const std::bad_alloc&) {
    throw Error(fmt::format("{}: there is not enough memory to load it",
                            scene::cleanText(first.string(), 1000)));
  }
}

}  // namespace

bool MeshSequence::isPattern(const std::filesystem::path& path) {
  std::error_code ignored;
  return !std::filesystem::is_regular_file(path, ignored) &&
         NumberedName::parse(path.filename().string()).has_value();
}

MeshSequence::MeshSequence(const std::filesystem::path& pattern, const LoadOptions& options)
    : state_(std::make_unique<State>(load(pattern, options))) {}
MeshSequence::MeshSequence(State&& state) : state_(std::make_unique<State>(std::move(state))) {}
MeshSequence::~MeshSequence() = default;
MeshSequence::MeshSequence(MeshSequence&&) noexcept = default;
MeshSequence& MeshSequence::operator=(MeshSequence&&) noexcept = default;

const Scene& MeshSequence::scene() const {
  return state_->scene;
}
int MeshSequence::firstNumber() const {
  return state_->files.first();
}
int MeshSequence::lastNumber() const {
  return state_->files.last();
}
std::filesystem::path MeshSequence::file(int number) const {
  return state_->files.file(number);
}

void MeshSequence::read(int number, std::vector<Vec3>& positionsMm) const {
  state_->files.read(number, positionsMm);
}

}  // namespace opaline
