#pragma once

#include <cstdint>
#include <vector>

#include "reference/moments.h"
#include "reference/patches.h"
#include "reference/run_control.h"

namespace opaline::reference {

/// A hierarchy over the patches of one body. Each node has four children with about as many patches
/// each.
class SourceTree {
 public:
  /// Throws Stopped.
  explicit SourceTree(Patches patches, std::stop_token stop = {});

  struct Node {
    Moments moments;
    std::uint32_t first = 0;  ///< child, or patch if there are no children
    std::uint32_t count = 0;  ///< of children, which are consecutive
  };

  bool isEmpty() const { return nodes_.empty(); }
  const Node& node(std::uint32_t index) const { return nodes_[index]; }  ///< 0 is the root
  const Patch& patch(std::uint32_t index) const { return patches_[index]; }
  std::size_t patchCount() const { return patches_.size(); }

 private:
  void build(std::uint32_t node, std::uint32_t* begin, std::uint32_t* end,
             const std::vector<Moments>& moments);

  std::vector<Patch> patches_;
  std::vector<Node> nodes_;
  std::stop_token stop_;
};

}  // namespace opaline::reference
