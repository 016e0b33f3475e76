#include "scene/mesh/mesh_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <optional>
#include <utility>

#include "opaline/error.h"
#include "scene/finish.h"
#include "scene/formats.h"
#include "scene/rig.h"
#include "scene/text.h"

namespace opaline::scene {

namespace {

namespace fs = std::filesystem;

constexpr int largestNumber = 999'999;
constexpr const char* purpose = "a sequence of meshes";

std::string shown(const fs::path& path) {
  return cleanText(path.string(), 1000);
}

/// Numbers of all matching files, ascending. The folder is listed once.
std::vector<int> numbersOf(const NumberedName& name, const fs::path& path) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::vector<int> numbers;
  std::error_code problem;
  for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end;
       entry.increment(problem)) {
    const auto number = name.numberOf(entry->path().filename().string());
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

MeshFiles::MeshFiles(const fs::path& pattern, const std::optional<fs::path>& morphTo)
    : folder_(pattern.parent_path()) {
  if (morphTo) {
    throw UsageError(fmt::format("{} is animated and cannot also turn into {}", shown(pattern),
                                 shown(*morphTo)));
  }
  auto name = NumberedName::parse(pattern.filename().string());
  if (!name) {
    throw UsageError(fmt::format(
        "{}: the name of a sequence has exactly one %d or %04d for the number", shown(pattern)));
  }
  name_ = std::move(*name);
  const std::vector<int> numbers = numbersOf(*name_, pattern);
  first_ = last_ = numbers.front();
  for (const int number : numbers) last_ += number == last_ + 1 ? 1 : 0;
  const auto next = std::upper_bound(numbers.begin(), numbers.end(), last_);
  if (next != numbers.end()) nextAfterGap_ = *next;
}

fs::path MeshFiles::file(int number) const {
  return folder_ / name_->with(number);
}

RawScene MeshFiles::loadFirst(const LogCallback& log) {
  const fs::path from = file(first_);
  if (nextAfterGap_) {
    note(log, fmt::format("{} is missing, so the sequence ends with the file before it, although "
                          "{} is there",
                          shown(file(last_ + 1)), shown(file(*nextAfterGap_))));
  }
  RawScene raw = loadModel(from, log);
  RawMesh& mesh = onlyStillObject(raw, shown(from), purpose).mesh;
  faces_ = faceListOf(mesh);
  // The rig goes through all repairs and scaling with the mesh. What becomes of it is what later
  // files need.
  startProvenance(mesh);
  raw.objects[0].rig = Rig{};
  raw.objects[0].rig->positions = mesh.positions;
  raw.objects[0].rig->normals.resize(mesh.positions.size());
  raw.nodes.resize(1);
  return raw;
}

void MeshFiles::followRepairs(const RawScene& repaired) {
  for (const Provenance& of : repaired.objects[0].mesh.provenance) origin_.push_back(of.vertex);
}

void MeshFiles::followPlace(Scene& scene) {
  Object& object = scene.objects[0];
  toScene_ = matrixFrom(object.rig->toScene);
  object.rig.reset();
  scene.nodes.clear();
}

void MeshFiles::read(int number, std::vector<Vec3>& positionsMm) const {
  const fs::path from = file(number);
  try {
    RawScene raw = loadModel(from, {});
    const RawMesh& mesh = onlyStillObject(raw, shown(from), purpose).mesh;
    const std::string difference = differenceOf(faceListOf(mesh), faces_);
    if (!difference.empty()) {
      throw Error(fmt::format("{} differs from {} in more than positions: {}", shown(from),
                              shown(file(first_)), difference));
    }
    positionsMm.resize(origin_.size());
    for (std::size_t v = 0; v < positionsMm.size(); ++v) {
      positionsMm[v] = toFloat(toScene_.point(toDouble(mesh.positions[origin_[v]])));
      if (!isFinite(positionsMm[v])) {
        throw Error(
            fmt::format("{}: the position of vertex {} is not finite", shown(from), origin_[v]));
      }
    }
  } catch (const std::bad_alloc&) {
    throw Error(fmt::format("{}: there is not enough memory to load it", shown(from)));
  }
}

}  // namespace opaline::scene
