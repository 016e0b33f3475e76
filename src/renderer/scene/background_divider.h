#pragma once

#include <future>
#include <optional>

#include "renderer/scene/division.h"

namespace opaline {

/// Divides a surface on another thread, one order at a time: while one is under way, only the last
/// that was wanted since comes next.
class BackgroundDivider {
 public:
  /// `merged` and its linings stay as they are until forget().
  void want(const DivisionOrder& order, const scene::MergedMesh& merged,
            const surfels::Linings& linings);
  /// What is done by now, or, for the patient, what was wanted last.
  std::optional<Division> take(bool patient);
  /// Waits for what is under way and drops it.
  void forget();

 private:
  void start();

  const scene::MergedMesh* merged_ = nullptr;
  const surfels::Linings* linings_ = nullptr;
  std::optional<DivisionOrder> next_;  // not begun
  DivisionOrder present_;              // under way
  std::future<Division> future_;
};

}  // namespace opaline
