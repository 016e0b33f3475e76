#pragma once

#include <future>
#include <optional>

#include "renderer/scene/division.h"

namespace opaline {

/// Divides a surface on another thread, one order at a time. Of the orders that arrive meanwhile,
/// only the last is carried out next.
class BackgroundDivider {
 public:
  /// `merged` and what is within its bodies stay as they are until forget().
  void want(const DivisionOrder& order, const scene::MergedMesh& merged, const Within& within);
  /// The division that is ready by now, if any; with `patient`, waits for the last order.
  std::optional<Division> take(bool patient);
  /// Waits for the current order and drops its result.
  void forget();

 private:
  void start();

  const scene::MergedMesh* merged_ = nullptr;
  const Within* within_ = nullptr;
  std::optional<DivisionOrder> next_;  // not begun yet
  DivisionOrder present_;              // being carried out
  std::future<Division> future_;
};

}  // namespace opaline
