// What a film does beside rendering, on threads of its own.

#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "film/frame_writer.h"
#include "film/kept_positions.h"
#include "film/positions_ahead.h"
#include "opaline/error.h"

namespace opaline::app {
namespace {

constexpr int frames = 200;

Frame frameOf(Frame frame, int number) {
  frame.images.resize(1);
  frame.images[0].rgba.assign(64, static_cast<float>(number));
  return frame;
}

TEST(FrameWriter, WritesEveryFrameWithAnyNumberOfWorkers) {
  for (const std::size_t workers : {1U, 4U}) {
    std::mutex mutex;
    std::vector<int> written;
    FrameWriter writer(workers, [&](int number, const Frame& frame) {
      EXPECT_EQ(frame.images.at(0).rgba.at(63), static_cast<float>(number));
      const std::lock_guard lock(mutex);
      written.push_back(number);
    });
    for (int i = 0; i < frames; ++i) {
      writer.push(i, frameOf(writer.take(), i));
      EXPECT_LE(writer.written(), static_cast<std::size_t>(i) + 1);
    }
    writer.finish();
    EXPECT_EQ(writer.written(), static_cast<std::size_t>(frames));
    if (workers > 1) std::sort(written.begin(), written.end());
    ASSERT_EQ(written.size(), static_cast<std::size_t>(frames));
    for (int i = 0; i < frames; ++i) EXPECT_EQ(written[static_cast<std::size_t>(i)], i);
  }
}

TEST(FrameWriter, SaysWhatWentWrongAndCanBeLeftAtAnyTime) {
  for (int failing = 0; failing < 20; ++failing) {
    FrameWriter writer(3, [&](int number, const Frame&) {
      if (number == failing) throw Error("the disk is full");
    });
    const auto writeAll = [&] {
      for (int i = 0; i < 20; ++i) writer.push(i, frameOf(writer.take(), i));
      writer.finish();
    };
    EXPECT_THROW(writeAll(), Error);
  }
}

TEST(PositionsAhead, AreThoseOfTheirFilesWhileOthersAreKeptAndTaken) {
  KeptPositions kept(4000 * sizeof(Vec3));
  std::vector<std::thread> readers;
  readers.reserve(3);
  for (int part = 0; part < 3; ++part)
    readers.emplace_back([&kept, part] {
      for (int i = part; i < frames; i += 3)
        kept.keep(i, std::vector<Vec3>(100, Vec3{static_cast<float>(i), 0, 0}));
    });
  PositionsAhead ahead(frames - 1, 1, [&](int number, std::vector<Vec3>& positionsMm) {
    if (!kept.take(number, positionsMm))
      positionsMm.assign(100, Vec3{static_cast<float>(number), 0, 0});
  });
  for (int i = 0; i < frames; i += i % 7 == 6 ? 2 : 1) {
    const std::vector<Vec3>& positionsMm = ahead.of(i);
    ASSERT_EQ(positionsMm.size(), 100U);
    EXPECT_EQ(positionsMm.back()[0], static_cast<float>(i));
  }
  for (std::thread& reader : readers) reader.join();
}

}  // namespace
}  // namespace opaline::app
