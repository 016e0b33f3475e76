#include "scene/mesh/ears.h"

#include <bit>

namespace opaline::scene {

void OrderedBits::reset(std::size_t limit) {
  count_ = 0;
  do {
    limit = (limit + 63) / 64;
    if (levels_.size() == count_) levels_.emplace_back();
    levels_[count_++].assign(limit, 0);
  } while (limit > 1);
}

void OrderedBits::insert(std::uint32_t number) {
  for (std::size_t level = 0; level < count_; ++level, number /= 64)
    levels_[level][number / 64] |= std::uint64_t{1} << (number % 64);
}

void OrderedBits::erase(std::uint32_t number) {
  for (std::size_t level = 0; level < count_; ++level, number /= 64) {
    std::uint64_t& word = levels_[level][number / 64];
    word &= ~(std::uint64_t{1} << (number % 64));
    if (word != 0) return;
  }
}

std::uint32_t OrderedBits::next(std::uint32_t from) const {
  for (std::size_t level = 0; level < count_ && from / 64 < levels_[level].size(); ++level) {
    const std::uint64_t rest = levels_[level][from / 64] >> (from % 64);
    if (rest == 0) {
      from = from / 64 + 1;
      continue;
    }
    std::uint32_t number = from + static_cast<std::uint32_t>(std::countr_zero(rest));
    while (level > 0)
      number = 64 * number + static_cast<std::uint32_t>(std::countr_zero(levels_[--level][number]));
    return number;
  }
  return none;
}

void Ears::start(std::span<const Double2> corners) {
  const auto count = static_cast<std::uint32_t>(corners.size());
  corners_ = corners;
  at_ = 0;
  before_.resize(count);
  after_.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    before_[i] = (i + count - 1) % count;
    after_[i] = (i + 1) % count;
  }
  tree_.build(corners);
  waitsFor_.assign(count, OrderedBits::none);
  firstWaiting_.assign(count, OrderedBits::none);
  waiting_.clear();
  hopeful_.reset(count);
  for (std::uint32_t i = 0; i < count; ++i) judge(i);
}

void Ears::judge(std::uint32_t corner) {
  const auto [a, b, c] = around(corner);
  waitsFor_[corner] = OrderedBits::none;
  if (turn(corners_[a], corners_[b], corners_[c]) > 0)
    hopeful_.insert(corner);
  else
    hopeful_.erase(corner);
}

Ears::Corners Ears::nextEar(std::size_t mostSteps, std::size_t& steps) {
  while (++steps <= mostSteps) {
    std::uint32_t corner = hopeful_.next(at_);
    if (corner == OrderedBits::none) corner = hopeful_.next(0);
    if (corner == OrderedBits::none) break;
    at_ = corner;
    const auto inside = tree_.inside(around(corner), steps);
    if (!inside) return around(corner);
    hopeful_.erase(corner);
    waitsFor_[corner] = *inside;
    waiting_.push_back({corner, firstWaiting_[*inside]});
    firstWaiting_[*inside] = static_cast<std::uint32_t>(waiting_.size() - 1);
  }
  return {};
}

void Ears::cut(const Corners& ear) {
  const auto [a, b, c] = ear;
  after_[a] = c;
  before_[c] = a;
  at_ = c;
  tree_.remove(b);
  hopeful_.erase(b);
  waitsFor_[b] = OrderedBits::none;
  judge(a);
  judge(c);
  for (std::uint32_t i = firstWaiting_[b]; i != OrderedBits::none; i = waiting_[i].next)
    if (waitsFor_[waiting_[i].corner] == b) judge(waiting_[i].corner);
}

Ears::Corners Ears::lastThree() const {
  const std::uint32_t b = after_[at_];
  const std::uint32_t c = after_[b];
  if (b > at_ && c > b) return {at_, b, c};
  return b < at_ && c > b ? Corners{b, c, at_} : Corners{c, at_, b};
}

}  // namespace opaline::scene
