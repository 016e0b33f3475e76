#include "growth.h"

#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <new>

#include "opaline/scene.h"
#include "paper/atlas/atlas.h"
#include "scene/mesh/insides.h"
#include "scene/mesh/merged_mesh.h"
#include "surfels/clusters.h"
#include "surfels/surfels.h"

namespace {

std::atomic<std::size_t> taken{0};
std::atomic<std::size_t> peak{0};
std::atomic<std::size_t> calls{0};

void note(void* memory) {
  const std::size_t now = taken += malloc_usable_size(memory);
  ++calls;
  std::size_t before = peak;
  while (now > before && !peak.compare_exchange_weak(before, now)) {
  }
}

}  // namespace

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  void* const memory = std::malloc(size > 0 ? size : 1);
  if (memory != nullptr) note(memory);
  return memory;
}
void* operator new(std::size_t size) {
  void* const memory = operator new(size, std::nothrow);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
void operator delete(void* memory) noexcept {
  if (memory != nullptr) taken -= malloc_usable_size(memory);
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  operator delete(memory);
}

namespace opaline::bench {

namespace {

namespace fs = std::filesystem;

template <typename Make>
auto measured(const char* stage, std::vector<Cost>& costs, const Make& make) {
  const std::size_t before = taken;
  peak = before;
  calls = 0;
  const std::clock_t start = std::clock();
  auto made = make();
  costs.push_back({stage, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC,
                   static_cast<double>(peak - before), static_cast<double>(calls)});
  return made;
}

fs::path written(const Family& family, std::uint32_t count) {
  const fs::path file =
      fs::temp_directory_path() / ("opaline-growth-" + std::to_string(getpid()) + family.extension);
  std::ofstream stream(file, std::ios::binary);
  const std::string bytes = family.file(count);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return file;
}

}  // namespace

std::vector<Cost> costsOf(const Family& family, std::uint32_t count) {
  constexpr std::size_t maxSurfels = 1U << 16U;
  constexpr std::size_t maxClusters = 8192;
  constexpr double spacingMm = 1;
  constexpr double largestClusterMm = 4;
  std::vector<Cost> costs;
  const fs::path file = written(family, count);
  const Scene scene = measured("read", costs, [&] { return loadScene(file); });
  fs::remove(file);
  const scene::MergedMesh mesh = scene::mergedMesh(scene);
  const core::RestSurface surface = scene::surfaceOf(mesh);
  measured("insides", costs,
           [&] { return scene::trianglesWithInside(mesh.positionsMm, mesh.triangles); });
  const std::vector<double> spacing(scene.objects.size(), spacingMm);
  const surfels::SurfelDivision division = measured(
      "surfels", costs, [&] { return surfels::makeSurfels(surface, spacing, maxSurfels); });
  const std::vector<surfels::ClusterOrder> orders(scene.objects.size(), {largestClusterMm});
  measured("clusters", costs,
           [&] { return surfels::makeClusters(surface, division, orders, maxClusters); });
  measured("atlas", costs, [&] { return atlas::makeAtlas(surface); });
  return costs;
}

double exponent(std::span<const double> costs, double factor) {
  const double middle = static_cast<double>(costs.size() - 1) / 2;
  double slope = 0;
  double squares = 0;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    if (!(costs[i] > 0)) return 0;
    const double x = static_cast<double>(i) - middle;
    slope += x * std::log(costs[i]) / std::log(factor);
    squares += x * x;
  }
  return slope / squares;
}

}  // namespace opaline::bench
