#include "soft_body/bodies.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

#include "gpu/gpu_fixture.h"
#include "gpu/helpers.h"
#include "renderer/shapes.h"

namespace opaline::test {

namespace {

using Matrix3 = Eigen::Matrix3d;
using Corners = std::array<Eigen::Vector3d, 8>;

std::array<double, 3> toArray(float x, float y, float z) {
  return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
}

// ∂x/∂X of the trilinear map at a place in [0,1]³.
Matrix3 gradientAt(const Corners& x, const std::array<double, 3>& at) {
  Matrix3 gradient = Matrix3::Zero();
  for (unsigned i = 0; i < 8; ++i)
    for (unsigned axis = 0; axis < 3; ++axis) {
      double slope = (i >> axis & 1U) != 0 ? 1 : -1;
      for (unsigned other = 0; other < 3; ++other)
        if (other != axis) slope *= (i >> other & 1U) != 0 ? at[other] : 1 - at[other];
      gradient.col(axis) += slope * x[i];
    }
  return gradient;
}

// The nearest rotation, by singular values.
Matrix3 rotationIn(const Matrix3& map) {
  const Eigen::JacobiSVD<Matrix3> svd(map, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Matrix3 sign = Matrix3::Identity();
  sign(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  return svd.matrixU() * sign * svd.matrixV().transpose();
}

// The mean over the cell divided by μ, by Gauss's rule with two points per axis, which is exact for
// this integrand.
double energyOfCell(const Corners& x) {
  std::array<Matrix3, 8> gradients;
  Matrix3 mean = Matrix3::Zero();
  double ratio = 0;
  for (unsigned q = 0; q < 8; ++q) {
    std::array<double, 3> at{};
    for (unsigned axis = 0; axis < 3; ++axis)
      at[axis] = 0.5 + ((q >> axis & 1U) != 0 ? 0.5 : -0.5) / std::sqrt(3.0);
    gradients[q] = gradientAt(x, at);
    mean += gradients[q] / 8;
    ratio += gradients[q].determinant() / 8;
  }
  const Matrix3 rotation = rotationIn(mean);
  double energy = 0.5 * soft_body::lambdaOverMu * (ratio - 1) * (ratio - 1);
  for (const Matrix3& gradient : gradients) energy += (gradient - rotation).squaredNorm() / 8;
  return energy;
}

double square(const std::array<double, 3>& v) {
  return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

}  // namespace

NodeState nodesOf(SoftBodyMotion& body) {
  NodeState nodes;
  for (const shared::SoftMotion& m :
       gpu::readAs<shared::SoftMotion>(*gpu::sharedDevice().device, body.state().motions)) {
    nodes.shift.push_back(toArray(m.shiftX, m.shiftY, m.shiftZ));
    nodes.step.push_back(toArray(m.aheadX, m.aheadY, m.aheadZ));
    // The node continues at its velocity, reduced by the damping.
    for (unsigned axis = 0; axis < 3; ++axis)
      nodes.step.back()[axis] =
          (nodes.step.back()[axis] - nodes.shift.back()[axis]) / body.dynamics().damping;
  }
  return nodes;
}

Field positionsOf(SoftBodyMotion& body) {
  const std::vector<float> floats =
      gpu::readAs<float>(*gpu::sharedDevice().device, body.state().positions);
  Field field;
  for (std::size_t i = 0; i + 2 < floats.size(); i += 3)
    field.push_back(toArray(floats[i], floats[i + 1], floats[i + 2]));
  return field;
}

std::vector<double> massesOf(const soft_body::Cage& cage) {
  std::vector<double> masses(cage.nodes.size(), 0);
  for (const auto& cell : cage.cells)
    for (const std::uint32_t n : cell) ++masses[n];
  return masses;
}

double volumeOf(const Field& positions, const std::vector<Triangle>& triangles) {
  double sum = 0;
  for (const Triangle& t : triangles) {
    const Eigen::Vector3d a(positions[t[0]].data());
    const Eigen::Vector3d b(positions[t[1]].data());
    const Eigen::Vector3d c(positions[t[2]].data());
    sum += a.dot(b.cross(c));
  }
  return sum / 6;
}

double farthest(const Field& a, const Field& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    most = std::max(most, std::hypot(a[i][0] - b[i][0], a[i][1] - b[i][1], a[i][2] - b[i][2]));
  return most;
}

bool isFinite(const Field& field) {
  return std::all_of(field.begin(), field.end(), [](const auto& v) {
    return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
  });
}

Mesh bar(int thicknessMm, int heightMm) {
  const float half = 0.5F * static_cast<float>(thicknessMm);
  const float middle = 0.5F * static_cast<float>(heightMm);
  return box({0, middle, 0}, {half, middle, half}, heightMm);
}

double energyOf(SoftBodyMotion& body) {
  const soft_body::Cage& cage = body.cage();
  const NodeState nodes = nodesOf(body);
  const std::vector<double> masses = massesOf(cage);
  double energy = 0;
  for (std::size_t n = 0; n < cage.nodes.size(); ++n)
    energy +=
        masses[n] / 16 * (square(nodes.step[n]) + body.dynamics().anchor * square(nodes.shift[n]));
  for (const auto& cell : cage.cells) {
    Corners x;
    for (unsigned i = 0; i < 8; ++i)
      for (unsigned axis = 0; axis < 3; ++axis)
        x[i][axis] = cage.nodes[cell[i]][axis] + nodes.shift[cell[i]][axis];
    energy += body.dynamics().waveNumber * energyOfCell(x);
  }
  return energy;
}

}  // namespace opaline::test
