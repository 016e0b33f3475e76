#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "builtin/builtin.h"

namespace opaline::builtin {

void scaleToDiagonal(Mesh& mesh, float diagonalMm) {
  assert(!mesh.positionsMm.empty());
  Vec3 low = mesh.positionsMm.front();
  Vec3 high = low;
  for (const Vec3& p : mesh.positionsMm) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  }
  const float scale = diagonalMm / std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  for (Vec3& p : mesh.positionsMm) p = {scale * p[0], scale * p[1], scale * p[2]};
}

}  // namespace opaline::builtin
