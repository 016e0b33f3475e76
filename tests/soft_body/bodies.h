#pragma once

#include <vector>

#include "opaline/scene.h"
#include "opaline/soft_body.h"
#include "renderer/motion/soft_body_motion.h"

namespace opaline::test {

/// A vector for each node or vertex, in double precision.
using Field = std::vector<std::array<double, 3>>;

/// The state of a soft body's nodes, in cells, and how far they move in a substep.
struct NodeState {
  Field shift;
  Field step;
};

NodeState nodesOf(SoftBodyMotion& body);
Field positionsOf(SoftBodyMotion& body);

/// The number of cells around each node, which is its mass in eighths of a cell's.
std::vector<double> massesOf(const soft_body::Cage& cage);

/// The volume that a closed mesh encloses.
double volumeOf(const Field& positions, const std::vector<Triangle>& triangles);

/// The largest distance between corresponding places of two fields.
double farthest(const Field& a, const Field& b);

bool isFinite(const Field& field);

/// A square bar standing on y = 0; thickness and height are whole mm.
Mesh bar(int thicknessMm, int heightMm);

/// Energy by the formulas of continuum mechanics, in double precision. It is the sum of kinetic
/// energy, the material's energy μ |F - R|² + ½ λ (J - 1)², and that of the pull to rest. R is the
/// rotation in a cell's mean F, and J the mean of det F. The unit is (mass of a cell) · (cell /
/// substep)².
double energyOf(SoftBodyMotion& body);

}  // namespace opaline::test
