#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "bssrdf/fresnel.h"

namespace opaline::test {

/// Exact radiative transfer in a half-space with isotropic scattering, Fresnel's interface and an
/// absorbing layer. What the medium returns of light from each direction follows from
/// Chandrasekhar's function H (1960, section 38).
class HalfSpace {
 public:
  HalfSpace(double albedo, double eta) : albedo_(albedo), eta_(eta) {
    const double critical = std::sqrt(1 - 1 / (eta * eta));
    addNodes(0, critical);
    addNodes(critical, 1);
    findH();
  }

  /// The share of even outside light that entered through the interface and leaves through a layer.
  double ofEvenLight(double thickness) const {
    double entering = 0;
    std::vector<double> down;
    for (const Node& node : nodes_) {
      const double transmitted = 1 - bssrdf::fresnelReflectanceInside(eta_, node.cosine);
      entering += 2 * node.weight * node.cosine * transmitted;
      down.push_back(transmitted * std::exp(-thickness / node.cosine));
    }
    std::vector<double> up(nodes_.size());
    for (std::size_t i = 0; i < up.size(); ++i)
      for (std::size_t j = 0; j < up.size(); ++j) up[i] += back(i, j) * down[j] / entering;
    return leaving(thickness, up);
  }

  /// The same for a beam with that cosine inside.
  double ofBeam(double thickness, double cosine) const {
    std::vector<double> up;
    const double through = std::exp(-thickness / cosine);
    for (const Node& node : nodes_)
      up.push_back(albedo_ / 4 * node.h * hAt(cosine) / (node.cosine + cosine) * through);
    return leaving(thickness, up);
  }

 private:
  struct Node {
    double cosine;
    double weight;
    double h;
  };

  // Gauss-Legendre nodes, five in each panel.
  void addNodes(double low, double high) {
    constexpr double at[] = {-0.906179845938663993, -0.538469310105683091, 0, 0.538469310105683091,
                             0.906179845938663993};
    constexpr double weight[] = {0.236926885056189088, 0.478628670499366468, 0.568888888888888889,
                                 0.478628670499366468, 0.236926885056189088};
    constexpr int panels = 4;
    const double half = (high - low) / (2 * panels);
    for (int p = 0; p < panels; ++p)
      for (int k = 0; k < 5; ++k)
        nodes_.push_back({low + half * (2 * p + 1 + at[k]), half * weight[k], 1});
  }

  double hAt(double cosine) const {
    double sum = 0;
    for (const Node& node : nodes_)
      sum += node.weight * node.cosine * node.h / (cosine + node.cosine);
    return 1 / (std::sqrt(1 - albedo_) + albedo_ / 2 * sum);
  }

  void findH() {
    for (int round = 0; round < 5000; ++round) {
      double change = 0;
      std::vector<double> next;
      for (const Node& node : nodes_) next.push_back(hAt(node.cosine));
      for (std::size_t i = 0; i < next.size(); ++i) {
        change = std::max(change, std::abs(next[i] - nodes_[i].h));
        nodes_[i].h = std::sqrt(nodes_[i].h * next[i]);  // else a white one's goes back and forth
      }
      if (change < 1e-12) return;
    }
  }

  // Radiance upwards at one node per radiance downwards at another.
  double back(std::size_t up, std::size_t down) const {
    const Node& i = nodes_[up];
    const Node& j = nodes_[down];
    return albedo_ / 2 * i.h * j.h * j.cosine * j.weight / (i.cosine + j.cosine);
  }

  // Includes all reflections back and forth inside.
  double leaving(double thickness, std::vector<double> first) const {
    std::vector<double> up = first;
    for (int round = 0; round < 5000; ++round) {
      std::vector<double> next = first;
      double change = 0;
      for (std::size_t i = 0; i < up.size(); ++i) {
        for (std::size_t j = 0; j < up.size(); ++j)
          next[i] += back(i, j) * bssrdf::fresnelReflectanceInside(eta_, nodes_[j].cosine) *
                     std::exp(-2 * thickness / nodes_[j].cosine) * up[j];
        change = std::max(change, std::abs(next[i] - up[i]));
      }
      up = next;
      if (change < 1e-10) break;
    }
    double sum = 0;
    for (std::size_t i = 0; i < up.size(); ++i)
      sum += 2 * nodes_[i].weight * nodes_[i].cosine *
             (1 - bssrdf::fresnelReflectanceInside(eta_, nodes_[i].cosine)) *
             std::exp(-thickness / nodes_[i].cosine) * up[i];
    return sum;
  }

  double albedo_;
  double eta_;
  std::vector<Node> nodes_;
};

}  // namespace opaline::test
