#include "reference/path/path_run.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <utility>

namespace opaline::reference {

namespace {

constexpr int blockEdge = 8;
constexpr double pixelsOfBlock = blockEdge * blockEdge;
constexpr std::uint64_t firstBatch = 4096;

}  // namespace

BlockError::Block BlockError::blockAt(int left, int top, int right, int bottom,
                                      const PathTracer& tracer, const Geometry& geometry,
                                      const CameraRays& rays) {
  Block shares;
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) {
      const Ray ray = rays.through(x, y);
      const auto hit = geometry.closestHit(ray.origin, ray.direction);
      if (!hit || geometry.scene().bodies[hit->point.body].opaque) continue;
      const std::size_t cell = tracer.cells().at(hit->point);
      const auto known = std::find_if(shares.begin(), shares.end(),
                                      [&](const Share& share) { return share.cell == cell; });
      if (known == shares.end()) {
        shares.push_back({cell, 1});
      } else {
        known->pixels += 1;
      }
    }
  }
  return shares;
}

BlockError::BlockError(const PathTracer& tracer, const Geometry& geometry, const CameraRays& rays,
                       int width, int height, const std::stop_token& stop)
    : tracer_(tracer) {
  std::vector<std::vector<Block>> rows(
      static_cast<std::size_t>((height + blockEdge - 1) / blockEdge));
  tbb::parallel_for(std::size_t{0}, rows.size(), [&](std::size_t row) {
    throwIfStopped(stop);
    const int top = static_cast<int>(row) * blockEdge;
    for (int left = 0; left < width; left += blockEdge) {
      Block block = blockAt(left, top, std::min(left + blockEdge, width),
                            std::min(top + blockEdge, height), tracer, geometry, rays);
      if (!block.empty()) rows[row].push_back(std::move(block));
    }
  });
  blocksOfPicture_ = rows.size() * static_cast<std::size_t>((width + blockEdge - 1) / blockEdge);
  for (std::vector<Block>& row : rows) std::ranges::move(row, std::back_inserter(blocks_));
}

BlockError::Sums BlockError::sums() const {
  Sums sums;
  for (const std::vector<Share>& block : blocks_) {
    for (const Share& share : block) {
      const Exitance exitance = tracer_.exitanceOfCell(share.cell);
      for (std::size_t c = 0; c < 3; ++c) {
        const double weight = share.pixels / pixelsOfBlock;
        sums.values += weight * exitance.value[c];
        sums.squaredErrors += std::pow(weight * exitance.error[c], 2);
      }
    }
  }
  return sums;
}

double BlockError::operator()() const {
  const Sums found = sums();
  if (!(found.values > 0)) return blocks_.empty() || !tracer_.shines() ? 0 : INFINITY;
  const double values = 3.0 * static_cast<double>(blocks_.size());
  return std::sqrt(found.squaredErrors / values) / (found.values / values);
}

double BlockError::ofPicture() const {
  return std::sqrt(sums().squaredErrors / (3.0 * static_cast<double>(blocksOfPicture_)));
}

double runPaths(PathTracer& tracer, const BlockError& error, const PathLimits& limits,
                const PathProgress& progress) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const auto since = [](Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
  };
  std::uint64_t batch = firstBatch;
  double reached = error();
  while (tracer.shines()) {
    if (limits.particles && tracer.particles() >= *limits.particles) break;
    if (limits.seconds && since(start) >= *limits.seconds) break;
    if (limits.error && reached <= *limits.error) break;
    if (!limits.particles && !limits.seconds && !limits.error) break;
    const std::uint64_t left =
        limits.particles ? *limits.particles - tracer.particles() : ~std::uint64_t{0};
    const auto begin = Clock::now();
    tracer.run(std::min(batch, left));
    const double took = since(begin);
    if (took < limits.secondsOfBatch / 2) batch *= 2;
    if (took > limits.secondsOfBatch && batch > firstBatch) batch /= 2;
    reached = error();
    if (progress) progress(tracer.particles(), since(start), reached);
  }
  return reached;
}

}  // namespace opaline::reference
