#include "film/positions_ahead.h"

#include <utility>

namespace opaline::app {

PositionsAhead::PositionsAhead(int lastNumber, int step, Read read)
    : lastNumber_(lastNumber), step_(step), read_(std::move(read)) {}

const std::vector<Vec3>& PositionsAhead::of(int number) {
  if (ahead_.valid() && aheadNumber_ == number) {
    spare_ = std::exchange(current_, ahead_.get());
  } else {
    // Positions read in vain do not matter, nor does an error in reading them.
    if (ahead_.valid()) ahead_.wait();
    current_ = readInto(number, std::move(current_));
  }
  if (number + step_ <= lastNumber_) readAhead(number + step_);
  return current_;
}

std::vector<Vec3> PositionsAhead::readInto(int number, std::vector<Vec3> memory) const {
  read_(number, memory);
  return memory;
}

void PositionsAhead::readAhead(int number) {
  aheadNumber_ = number;
  ahead_ = std::async(std::launch::async, [this, number, memory = std::move(spare_)]() mutable {
    return readInto(number, std::move(memory));
  });
}

}  // namespace opaline::app
