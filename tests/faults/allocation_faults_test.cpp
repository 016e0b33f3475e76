// Every allocation of the host fails once. A separate program, because it replaces the allocator.
// OPALINE_FAULT_STRIDE=1 in the environment tests them all.

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <new>
#include <optional>
#include <vector>

#include "faults/tiny_options.h"
#include "opaline/error.h"
#include "opaline/renderer.h"
#include "opaline/scene_file.h"
#include "renderer/shapes.h"

namespace {

// For all threads, as the library has some.
std::atomic<long> untilFailure = 0;  // 0: none fails
std::atomic<long> living = 0;

void* allocated(std::size_t bytes, std::size_t alignment) {
  if (untilFailure > 0 && --untilFailure == 0) return nullptr;
  bytes = bytes == 0 ? 1 : bytes;
  ++living;
  return alignment == 0
             ? std::malloc(bytes)
             : std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
}

void* allocatedOrThrown(std::size_t bytes, std::size_t alignment) {
  void* memory = allocated(bytes, alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void freed(void* memory) {
  if (memory != nullptr) --living;
  std::free(memory);
}

}  // namespace

// Array forms call these. If they were inlined, GCC would warn of a mismatched pair.
[[gnu::noinline]] void* operator new(std::size_t bytes) {
  return allocatedOrThrown(bytes, 0);
}
[[gnu::noinline]] void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return allocatedOrThrown(bytes, static_cast<std::size_t>(alignment));
}
[[gnu::noinline]] void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  return allocated(bytes, 0);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  freed(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  freed(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept {
  freed(memory);
}

namespace opaline {
namespace {

using namespace test;

int strideOr(int stride) {
  const char* wanted = std::getenv("OPALINE_FAULT_STRIDE");
  return wanted == nullptr ? stride : std::atoi(wanted);
}

/// Runs `run` with its first allocation failing, then `after`; then with the following ones, every
/// `stride`-th, until a run has no more. `after` gets the number of allocations left by the run.
void failEachAllocation(int stride, const std::function<void()>& run,
                        const std::function<void(long left)>& after) {
  int failed = 0;
  for (long nth = 1; !testing::Test::HasFailure(); nth += strideOr(stride)) {
    bool ended = false;
    untilFailure = nth;
    try {
      run();
      ended = true;
    } catch (const UsageError& error) {
      untilFailure = 0;
      ADD_FAILURE() << "counts as a mistake of the caller: " << error.what();
    } catch (const Error& error) {
      untilFailure = 0;
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    } catch (const std::bad_alloc&) {
    }
    const long left = living;
    const bool any = untilFailure.exchange(0) == 0;
    SCOPED_TRACE("after allocation " + std::to_string(nth));
    after(left);
    if (ended && !any) break;
    ++failed;
  }
  std::cout << failed << " allocations failed" << std::endl;
}

Scene litBall() {
  Scene scene = sceneOf(sphere({0, 0, 0}, 5, 1), marble(), {0, 0, 25}, 6);
  scene.lighting.directional = {{{0.3F, 0.5F, 0.8F}, {1, 1, 1}}};
  scene.lighting.ambient = {0.1F, 0.1F, 0.1F};
  return scene;
}

TEST(AllocationFaults, ARendererGoesOn) {
  Renderer renderer;
  const auto picture = [&] {
    renderer.setScene(litBall());
    return renderer.render(tinyOptions()).images.at(0).rgba;
  };
  const std::vector<float> expected = picture();
  failEachAllocation(
      499, [&] { EXPECT_EQ(picture(), expected); }, [&](long) { EXPECT_EQ(picture(), expected); });
}

TEST(AllocationFaults, EditsAreMadeOrNot) {
  Renderer renderer;
  renderer.setScene(litBall());
  View view(renderer, tinyOptions());
  const auto shown = [&] { return view.render().images.at(0).rgba; };
  shown();
  Lighting lighting = litBall().lighting;
  lighting.points.push_back({{0, 20, 0}, {50, 100, 100}});
  const auto edit = [&] {
    renderer.setLighting(lighting);
    renderer.setMedium(0, skin());
    shown();
  };
  edit();
  const std::vector<float> expected = shown();
  failEachAllocation(
      997,
      [&] {
        renderer.setLighting(litBall().lighting);
        renderer.setMedium(0, marble());
        shown();
        edit();
      },
      [&](long) {
        edit();
        EXPECT_EQ(shown(), expected);
      });
}

TEST(AllocationFaults, OpeningLeavesNothing) {
  { const Renderer first; }
  const long before = living;
  failEachAllocation(
      101, [] { const Renderer renderer; }, [&](long left) { EXPECT_EQ(left, before); });
}

// Not glTF: nlohmann::json allocates in its destructor, where a failure cannot be handled.
TEST(AllocationFaults, ReadingLeavesNothing) {
  const std::filesystem::path corpus =
      std::filesystem::path(OPALINE_SOURCE_DIR) / "tests/fuzz/corpus";
  for (const char* name :
       {"obj/materials.obj", "obj/plain.obj", "ply/ascii.ply", "ply/binary.ply"}) {
    SCOPED_TRACE(name);
    loadScene(corpus / name);
    const long before = living;
    failEachAllocation(
        1, [&] { loadScene(corpus / name); }, [&](long left) { EXPECT_EQ(left, before); });
  }
}

}  // namespace
}  // namespace opaline
