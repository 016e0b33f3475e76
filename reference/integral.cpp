#include "reference/integral.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "bssrdf/profile.h"
#include "opaline/error.h"

namespace opaline::reference {

namespace {

double areaOf(const Body& body) {
  double sum = 0;
  for (const Triangle& t : body.triangles) {
    const Vector& a = body.positionsMm[t[0]];
    sum += 0.5 * length(cross(body.positionsMm[t[1]] - a, body.positionsMm[t[2]] - a));
  }
  return sum;
}

/// The borders of shadows are refined until their share of the error is about the tolerance. With
/// patches of size h across a border, B beside it is off by about h/30 mean free paths.
PatchOptions patchOptions(double diagonalMm, double depthMm, const IntegralOptions& integral) {
  const double tolerance = integral.tolerance;
  PatchOptions options;
  options.stop = integral.stop;
  options.tolerance = 0.25 * tolerance;
  options.largestMm = std::max(depthMm, diagonalMm / 100);
  options.smallestMm =
      std::max(std::min(30 * tolerance, 0.5) * depthMm, std::ldexp(diagonalMm, -16));
  return options;
}

// A surface so rugged that shadows are everywhere is refined less; the error reports it.
Patches makeBoundedPatches(const Geometry& geometry, const Irradiance& irradiance,
                           std::uint32_t body, PatchOptions options) {
  constexpr std::size_t usual = 800'000;
  options.most = usual + 4 * geometry.scene().bodies[body].triangles.size();
  for (; options.smallestMm < geometry.box().diagonalMm(); options.smallestMm *= 2) {
    if (auto patches = makePatches(geometry, irradiance, body, options)) return *std::move(patches);
  }
  options.most = std::numeric_limits<std::size_t>::max();
  return *makePatches(geometry, irradiance, body, options);
}

// The patches of all parts of the body that this one belongs to.
Patches patchesOfWhole(const Geometry& geometry, const Irradiance& irradiance, std::uint32_t body,
                       const PatchOptions& options) {
  Patches all;
  for (std::uint32_t part = 0; part < geometry.scene().bodies.size(); ++part) {
    if (wholeOf(geometry.scene(), part) != wholeOf(geometry.scene(), body)) continue;
    const Patches its = makeBoundedPatches(geometry, irradiance, part, options);
    all.patches.insert(all.patches.end(), its.patches.begin(), its.patches.end());
    all.moments.insert(all.moments.end(), its.moments.begin(), its.moments.end());
    all.withBorders += its.withBorders;
  }
  return all;
}

double areaOfWhole(const Scene& scene, std::uint32_t body) {
  double area = 0;
  for (std::uint32_t part = 0; part < scene.bodies.size(); ++part)
    if (wholeOf(scene, part) == wholeOf(scene, body)) area += areaOf(scene.bodies[part]);
  return area;
}

/// Sums what the nodes of a tree contribute to one point. The pieces with the least certain
/// contributions are divided until the sum is certain enough.
class Summation {
 public:
  Summation(const SourceTree& tree, const std::array<Kernel, 3>& kernels, double depthMm,
            const Vector& place)
      : tree_(tree), kernels_(kernels), depthMm_(depthMm), place_(place) {}

  Exitance sum(double tolerance, const Colour& negligible) {
    negligible_ = negligible;
    addNode(0);
    // A guard against tolerances that rounding cannot meet. The remaining uncertainty is in the
    // error.
    constexpr std::size_t mostPieces = 1U << 22U;
    while (!isCertain(tolerance) && !heap_.empty() && pieces_.size() < mostPieces) divideWorst();
    return total();
  }

 private:
  static constexpr std::uint32_t none = ~0U;

  struct Piece {
    Contribution contribution;
    Colour smoothError{};
    Colour borderVariance{};
    std::uint32_t node = none;  ///< none: part of a patch
    std::uint32_t part = none;
    bool isDivided = false;
  };
  struct Part {
    std::uint32_t patch;
    SubTriangle triangle;
    Colour smoothError{};     ///< of the flux; each division quarters it
    Colour borderVariance{};  ///< likewise, so that a patch's parts add up to its variance
  };
  struct Entry {
    double uncertainty;
    std::uint32_t piece;
    bool operator<(const Entry& other) const {
      return std::pair(uncertainty, piece) < std::pair(other.uncertainty, other.piece);
    }
  };

  bool isCertain(double tolerance) const {
    for (std::size_t c = 0; c < 3; ++c) {
      if (bound_[c] > tolerance * (std::abs(exitance_[c]) + negligible_[c])) return false;
    }
    return true;
  }

  void addNode(std::uint32_t index) {
    const SourceTree::Node& node = tree_.node(index);
    if (!isExpandable(node.moments, place_, depthMm_)) return divideNode(index);
    Piece piece;
    piece.node = index;
    for (std::size_t c = 0; c < 3; ++c) {
      piece.smoothError[c] = node.moments.channels[c].smoothError;
      piece.borderVariance[c] = node.moments.channels[c].borderVariance;
    }
    add(piece, node.moments);
  }

  void addPart(const Part& part) {
    const Moments moments = momentsOf(tree_.patch(part.patch), part.triangle);
    if (!isExpandable(moments, place_, depthMm_)) return dividePart(part);
    Piece piece;
    piece.part = static_cast<std::uint32_t>(parts_.size());
    piece.smoothError = part.smoothError;
    piece.borderVariance = part.borderVariance;
    parts_.push_back(part);
    add(piece, moments);
  }

  void divideNode(std::uint32_t index) {
    const SourceTree::Node& node = tree_.node(index);
    if (node.count == 0) {
      Part whole{node.first, wholeTriangle, {}, {}};
      for (std::size_t c = 0; c < 3; ++c) {
        whole.smoothError[c] = node.moments.channels[c].smoothError;
        whole.borderVariance[c] = node.moments.channels[c].borderVariance;
      }
      return dividePart(whole);
    }
    for (std::uint32_t i = 0; i < node.count; ++i) addNode(node.first + i);
  }

  void dividePart(const Part& part) {
    for (const SubTriangle& quarter : quarters(part.triangle)) {
      Part next{part.patch, quarter, part.smoothError, part.borderVariance};
      for (std::size_t c = 0; c < 3; ++c) {
        next.smoothError[c] /= 4;
        next.borderVariance[c] /= 4;
      }
      addPart(next);
    }
  }

  void add(Piece& piece, const Moments& moments) {
    piece.contribution = contribution(moments, place_, kernels_);
    double uncertainty = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      exitance_[c] += piece.contribution.exitance[c];
      bound_[c] += piece.contribution.bound[c];
      const double scale = std::abs(exitance_[c]) + negligible_[c];
      if (scale > 0) uncertainty = std::max(uncertainty, piece.contribution.bound[c] / scale);
    }
    heap_.push_back({uncertainty, static_cast<std::uint32_t>(pieces_.size())});
    std::push_heap(heap_.begin(), heap_.end());
    pieces_.push_back(piece);
  }

  void divideWorst() {
    std::pop_heap(heap_.begin(), heap_.end());
    const std::uint32_t index = heap_.back().piece;
    heap_.pop_back();
    pieces_[index].isDivided = true;
    const Contribution& contribution = pieces_[index].contribution;
    for (std::size_t c = 0; c < 3; ++c) {
      exitance_[c] -= contribution.exitance[c];
      bound_[c] -= contribution.bound[c];
    }
    if (pieces_[index].node != none) return divideNode(pieces_[index].node);
    dividePart(Part(parts_[pieces_[index].part]));
  }

  Exitance total() const {
    Exitance exitance;
    Colour variance{};
    for (const Piece& piece : pieces_) {
      if (piece.isDivided) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        const double reflectance = piece.contribution.reflectance[c];
        exitance.value[c] += piece.contribution.exitance[c];
        exitance.error[c] += piece.contribution.bound[c] + piece.smoothError[c] * reflectance;
        variance[c] += piece.borderVariance[c] * reflectance * reflectance;
      }
    }
    for (std::size_t c = 0; c < 3; ++c) exitance.error[c] += std::sqrt(variance[c]);
    return exitance;
  }

  const SourceTree& tree_;
  const std::array<Kernel, 3>& kernels_;
  double depthMm_;
  Vector place_;
  Colour negligible_{};
  Colour exitance_{};
  Colour bound_{};
  std::vector<Piece> pieces_;
  std::vector<Part> parts_;
  std::vector<Entry> heap_;
};

}  // namespace

Integral::Integral(const Geometry& geometry, const Irradiance& irradiance,
                   const IntegralOptions& options)
    : tolerance_(options.tolerance) {
  if (!(tolerance_ >= 1e-7 && tolerance_ <= 0.5)) {
    throw UsageError(
        fmt::format("the tolerance is {}, but must be from 1e-7 to 0.5", options.tolerance));
  }
  const Scene& scene = geometry.scene();
  for (std::uint32_t body = 0; body < scene.bodies.size(); ++body) {
    if (scene.bodies[body].opaque) {
      bodies_.emplace_back();
      continue;
    }
    if (scene.bodies[body].paint)
      throw UsageError("the integral knows no paint, and a body is painted; path tracing does");
    const auto profiles =
        bssrdf::makeProfiles(bssrdf::modelOf(options.transport), scene.bodies[body].medium);
    const std::array<Kernel, 3> kernels{Kernel(profiles[0]), Kernel(profiles[1]),
                                        Kernel(profiles[2])};
    const double depth =
        std::min({kernels[0].depthMm(), kernels[1].depthMm(), kernels[2].depthMm()});
    SourceTree tree(patchesOfWhole(geometry, irradiance, body,
                                   patchOptions(geometry.box().diagonalMm(), depth, options)),
                    options.stop);
    Colour negligible{};
    const double area = areaOfWhole(scene, body);
    for (std::size_t c = 0; c < 3 && !tree.isEmpty() && area > 0; ++c) {
      negligible[c] =
          1e-12 * tree.node(0).moments.channels[c].flux / area * profiles[c].totalReflectance();
    }
    bodies_.push_back(BodySources{kernels, depth, negligible, std::move(tree)});
  }
}

Exitance Integral::at(const SurfacePoint& point) const {
  const std::optional<BodySources>& body = bodies_[point.body];
  if (!body || body->tree.isEmpty()) return {};
  return Summation(body->tree, body->kernels, body->depthMm, point.position)
      .sum(0.5 * tolerance_, body->negligible);
}

std::size_t Integral::patchCount() const {
  std::size_t count = 0;
  for (const auto& body : bodies_)
    if (body) count += body->tree.patchCount();
  return count;
}

}  // namespace opaline::reference
