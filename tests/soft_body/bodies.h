#pragma once

#include <vector>

#include "opaline/scene.h"
#include "opaline/soft_body.h"
#include "renderer/motion/soft_body_motion.h"

namespace opaline::test {

/// A vector for each node or vertex, in double precision.
using Field = std::vector<std::array<double, 3>>;

/// How a soft body's nodes are, in cells, and how far they go in a substep.
struct NodeState {
  Field shift;
  Field step;
};

NodeState nodesOf(SoftBodyMotion& body);
Field positionsOf(SoftBodyMotion& body);

/// Numbers of cells around each node: its mass in eighths of a cell's.
std::vector<double> massesOf(const soft_body::Cage& cage);

/// What a closed mesh encloses.
double volumeOf(const Field& positions, const std::vector<Triangle>& triangles);

/// The longest way between places of two fields.
double farthest(const Field& a, const Field& b);

bool isFinite(const Field& field);

/// A square bar that stands on y = 0, whole mm thick and high.
Mesh bar(int thicknessMm, int heightMm);

/// By the formulas of continuum mechanics, in double precision: kinetic energy, that of the
/// material, μ |F - R|² + ½ λ (J - 1)² with R the rotation in the mean of F and J the mean of det F
/// in a cell, and that of the pull to rest; all in (mass of a cell) · (cell / substep)².
double energyOf(SoftBodyMotion& body);

}  // namespace opaline::test
