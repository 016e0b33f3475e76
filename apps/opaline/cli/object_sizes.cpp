#include "cli/object_sizes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "cli/measures.h"
#include "opaline/half_space.h"

namespace opaline::app {

namespace {

constexpr double mostDiffusionLengths = 1000;
constexpr double leastDiffusionLengths = 2;

/// An object beside how far light goes in it.
struct UnusualSize {
  const Object* object;
  double mm;
  double lengthMm;
  const char* lengths;  ///< what these are called
  double ratio;
  std::size_t others = 0;  ///< of the same medium, which look alike

  bool looksLikeFog() const { return ratio < leastDiffusionLengths; }
  bool isFarther(const UnusualSize& other) const {
    return looksLikeFog() ? ratio < other.ratio : ratio > other.ratio;
  }
};

/// Where nothing is absorbed a body may be as large as it likes.
std::optional<UnusualSize> unusualSize(const Object& object) {
  if (object.opaque) return std::nullopt;
  const auto edges = sizeMm(object);
  const double mm = std::hypot(edges[0], edges[1], edges[2]);
  const MediumLengths lengths = lengthsOf(object.medium);
  const bool absorbs = lengths.longestDiffusionMm.has_value();
  const double lengthMm =
      absorbs ? *lengths.longestDiffusionMm
              : *std::max_element(lengths.meanFreePathMm.begin(), lengths.meanFreePathMm.end());
  const UnusualSize size{&object, mm, lengthMm, absorbs ? "diffusion lengths" : "mean free paths",
                         mm / lengthMm};
  if (size.looksLikeFog() || (absorbs && size.ratio > mostDiffusionLengths)) return size;
  return std::nullopt;
}

}  // namespace

std::array<double, 3> sizeMm(const Object& object) {
  const std::vector<Vec3>& positions = object.mesh.positionsMm;
  std::array<double, 3> size{};
  for (std::size_t axis = 0; axis < size.size() && !positions.empty(); ++axis) {
    const auto [least, most] =
        std::minmax_element(positions.begin(), positions.end(),
                            [&](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; });
    size[axis] = double{(*most)[axis] - (*least)[axis]};
  }
  return size;
}

std::vector<std::string> notesOnSize(const Scene& scene) {
  std::vector<UnusualSize> sizes;
  for (const Object& object : scene.objects) {
    const std::optional<UnusualSize> size = unusualSize(object);
    if (!size) continue;
    const auto alike = std::find_if(sizes.begin(), sizes.end(), [&](const UnusualSize& other) {
      return other.object->medium.name == object.medium.name &&
             other.looksLikeFog() == size->looksLikeFog();
    });
    if (alike == sizes.end()) {
      sizes.push_back(*size);
      continue;
    }
    const std::size_t others = alike->others + 1;
    if (size->isFarther(*alike)) *alike = *size;
    alike->others = others;
  }
  std::vector<std::string> notes;
  for (const UnusualSize& size : sizes) {
    const std::string others =
        size.others == 0 ? "" : fmt::format(", as will {} more of its medium", size.others);
    notes.push_back(fmt::format(
        "object {} measures {}, {:.3g} {} of {} ({}): it will look {}{}; --diagonal-mm sets the "
        "model's size",
        size.object->name, lengthText(size.mm, 4), size.ratio, size.lengths,
        size.object->medium.name, lengthText(size.lengthMm),
        size.looksLikeFog() ? "like fog" : "opaque", others));
  }
  return notes;
}

}  // namespace opaline::app
