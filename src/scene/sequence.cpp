#include "opaline/sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <optional>

#include "core/numbered_name.h"
#include "opaline/error.h"
#include "scene/finish.h"
#include "scene/formats.h"
#include "scene/matrix.h"
#include "scene/rig.h"
#include "scene/same_topology.h"
#include "scene/text.h"

namespace opaline {

namespace {

namespace fs = std::filesystem;

constexpr int largestNumber = 999'999;

/// Numbered files of one folder.
struct Pattern {
  fs::path folder;
  core::NumberedName name;
};

std::optional<Pattern> patternIn(const fs::path& path) {
  const auto name = core::NumberedName::parse(path.filename().string());
  if (!name) return std::nullopt;
  return Pattern{path.parent_path(), *name};
}

std::string shown(const fs::path& path) {
  return scene::cleanText(path.string(), 1000);
}

/// Numbers of all files that fit, ascending; the folder is listed once.
std::vector<int> numbersOf(const Pattern& pattern, const fs::path& path) {
  const fs::path folder = pattern.folder.empty() ? fs::path(".") : pattern.folder;
  std::vector<int> numbers;
  std::error_code problem;
  for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end;
       entry.increment(problem)) {
    const auto number = pattern.name.numberOf(entry->path().filename().string());
    if (number && *number <= largestNumber) numbers.push_back(*number);
  }
  if (problem) {
    throw Error(fmt::format("{}: its folder cannot be listed: {}", shown(path), problem.message()));
  }
  if (numbers.empty()) {
    throw Error(fmt::format("{}: there is no file of this pattern", shown(path)));
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

}  // namespace

struct MeshSequence::State {
  Pattern pattern;
  int first = 0;
  int last = 0;
  Scene scene;
  scene::FaceList faces;
  std::vector<std::uint32_t> origin;  ///< per vertex of the scene the file's
  scene::Matrix4 toScene;

  std::filesystem::path file(int number) const {
    return pattern.folder / pattern.name.with(number);
  }
};

bool MeshSequence::isPattern(const std::filesystem::path& path) {
  std::error_code ignored;
  return !fs::is_regular_file(path, ignored) && patternIn(path).has_value();
}

MeshSequence::MeshSequence(const std::filesystem::path& path, const LoadOptions& options)
    : state_(std::make_unique<State>()) {
  scene::requireSensible(options);
  if (options.morphTo) {
    throw UsageError(fmt::format("{} moves by itself and cannot become {} as well", shown(path),
                                 shown(*options.morphTo)));
  }
  const auto pattern = patternIn(path);
  if (!pattern) {
    throw UsageError(fmt::format(
        "{}: the name of a sequence has exactly one %d or %04d for the number", shown(path)));
  }
  state_->pattern = *pattern;
  const std::vector<int> numbers = numbersOf(*pattern, path);
  state_->first = state_->last = numbers.front();
  for (const int number : numbers) state_->last += number == state_->last + 1 ? 1 : 0;
  const fs::path file = state_->file(state_->first);
  try {
    scene::RawScene raw = scene::loadModel(file, options.log);
    scene::RawMesh& mesh = scene::onlyStillObject(raw, shown(file), "a sequence of meshes").mesh;
    state_->faces = scene::faceListOf(mesh);
    // Repairs and scales the rig with the mesh; what comes of it is what the next frames need.
    scene::startProvenance(mesh);
    raw.objects[0].rig = Rig{};
    raw.objects[0].rig->positions = mesh.positions;
    raw.objects[0].rig->normals.resize(mesh.positions.size());
    raw.nodes.resize(1);
    std::vector<Repair> repairs;
    raw = scene::inMillimetres(std::move(raw), file, !options.diagonalMm, options.log, repairs);
    for (const scene::Provenance& of : raw.objects[0].mesh.provenance) {
      state_->origin.push_back(of.vertex);
    }
    state_->scene = scene::finished(std::move(raw), file, std::move(repairs), options);
  } catch (const std::bad_alloc&) {
    throw Error(fmt::format("{}: there is not enough memory to load it", shown(file)));
  }
  Object& object = state_->scene.objects[0];
  state_->toScene = scene::matrixFrom(object.rig->toScene);
  object.rig.reset();
  state_->scene.nodes.clear();
}

MeshSequence::~MeshSequence() = default;
MeshSequence::MeshSequence(MeshSequence&&) noexcept = default;
MeshSequence& MeshSequence::operator=(MeshSequence&&) noexcept = default;

const Scene& MeshSequence::scene() const {
  return state_->scene;
}
int MeshSequence::firstNumber() const {
  return state_->first;
}
int MeshSequence::lastNumber() const {
  return state_->last;
}
std::filesystem::path MeshSequence::file(int number) const {
  return state_->file(number);
}

void MeshSequence::read(int number, std::vector<Vec3>& positionsMm) const {
  const fs::path file = state_->file(number);
  try {
    scene::RawScene raw = scene::loadModel(file, {});
    const scene::RawMesh& mesh =
        scene::onlyStillObject(raw, shown(file), "a sequence of meshes").mesh;
    const std::string difference = scene::differenceOf(scene::faceListOf(mesh), state_->faces);
    if (!difference.empty()) {
      throw Error(fmt::format("{} differs from {} in more than positions: {}", shown(file),
                              shown(state_->file(state_->first)), difference));
    }
    positionsMm.resize(state_->origin.size());
    for (std::size_t v = 0; v < positionsMm.size(); ++v) {
      const Vec3& from = mesh.positions[state_->origin[v]];
      positionsMm[v] = scene::toFloat(state_->toScene.point(scene::toDouble(from)));
      if (!scene::isFinite(positionsMm[v])) {
        throw Error(fmt::format("{}: the position of vertex {} is not finite", shown(file),
                                state_->origin[v]));
      }
    }
  } catch (const std::bad_alloc&) {
    throw Error(fmt::format("{}: there is not enough memory to load it", shown(file)));
  }
}

}  // namespace opaline
