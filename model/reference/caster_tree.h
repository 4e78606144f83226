#pragma once
/// A tree of grids over the casters: the exact reference's acceleration structure.
///
/// Every node is a square whose side is a power of two, cut into 2^n x 2^n equal children. A caster
/// goes down to every child that it meets, but stays where it covers a node wholly. Grids are as
/// fine as the casters' sizes and numbers ask for, so small, huge and crowded casters all stay
/// cheap; the extent comes from the casters, so scale does not matter.
#include <cstdint>
#include <vector>

#include "model/reference/triangle.h"
#include "traces/format/records.h"

namespace kagesen {

class CasterTree {
 public:
  /// What of a caster counts.
  enum class Shape : std::uint8_t {
    kOutline,  ///< its triangle; those of zero area are left out
    kBox,      ///< its bounding box
  };
  /// A caster that meets a leaf. `nearest`: depth of its nearest vertex.
  struct Ref {
    std::uint32_t nearest, caster;
  };
  /// A caster that covers a node wholly. nearest, farthest: bounds of its plane's depth there.
  struct Cover {
    std::uint32_t nearest, farthest, caster, object;
  };
  struct Node {
    std::uint32_t children = 0;                      ///< index of the first, row by row; 0: a leaf
    std::uint32_t refs_begin = 0, refs_end = 0;      ///< of a leaf, nearest first
    std::uint32_t covers_begin = 0, covers_end = 0;  ///< nearest first
    std::uint8_t child_shift = 0;                    ///< log2 of a child's side, units
    std::uint8_t fan_out = 0;                        ///< log2 of the children a row
  };

  /// Keeps a reference to the casters. Memory: at most about 13 refs a caster plus 1 M.
  CasterTree(const std::vector<Caster>& casters, Shape shape);

  const std::vector<Caster>& casters() const { return casters_; }
  const std::vector<Node>& nodes() const { return nodes_; }
  const Ref* refs() const { return refs_.data(); }
  const Cover* covers() const { return covers_.data(); }
  /// No caster lies outside this box. Empty trees have x0 > x1.
  const Box& box() const { return box_; }
  /// log2 of the root's side, units. Its corner is the box's (x0, y0).
  int root_size() const { return root_size_; }
  bool contains(std::int32_t x, std::int32_t y) const {
    return x >= box_.x0 && x <= box_.x1 && y >= box_.y0 && y <= box_.y1;
  }
  std::uint64_t bytes() const;

  /// Calls cover(const Cover&) and ref(const Ref&) nearest first a node, from the root to the leaf
  /// that holds (x, y), which must be contained. They return kNext, kSkipNode (rest of this list is
  /// of no use) or kStop.
  enum Step { kNext, kSkipNode, kStop };
  template <class OnCover, class OnRef>
  void visit_point(std::int32_t x, std::int32_t y, OnCover on_cover, OnRef on_ref) const {
    const auto cx = std::uint32_t(std::int64_t{x} - box_.x0);
    const auto cy = std::uint32_t(std::int64_t{y} - box_.y0);
    const Node* node = nodes_.data();
    for (;;) {
      for (std::uint32_t i = node->covers_begin; i != node->covers_end; ++i) {
        const Step step = on_cover(covers_[i]);
        if (step == kStop) return;
        if (step == kSkipNode) break;
      }
      if (node->children == 0) break;
      const std::uint32_t mask = (1u << node->fan_out) - 1;
      const std::uint32_t column = (cx >> node->child_shift) & mask;
      const std::uint32_t row = (cy >> node->child_shift) & mask;
      node = &nodes_[node->children + (row << node->fan_out) + column];
    }
    for (std::uint32_t i = node->refs_begin; i != node->refs_end; ++i) {
      if (on_ref(refs_[i]) != kNext) return;
    }
  }

  /// log2 of the side of the leaf that holds (x, y), units; a small one if no caster is near.
  int leaf_size(std::int32_t x, std::int32_t y) const {
    int size = root_size_;
    if (!contains(x, y)) return std::max(size - 6, 0);
    const auto cx = std::uint32_t(std::int64_t{x} - box_.x0);
    const auto cy = std::uint32_t(std::int64_t{y} - box_.y0);
    const Node* node = nodes_.data();
    while (node->children != 0) {
      size = node->child_shift;
      const std::uint32_t mask = (1u << node->fan_out) - 1;
      node = &nodes_[node->children + ((cy >> size & mask) << node->fan_out) + (cx >> size & mask)];
    }
    return size;
  }

  /// Calls visit(const Node&) for every node that meets the box, parents first, as long as it
  /// returns true. Leaves out a node, with all below it, where enter(index) is false. False: it was
  /// stopped.
  template <class Enter, class Visit>
  bool visit_box(const Box& box, Enter enter, Visit visit) const {
    const std::int64_t root_last = (std::int64_t{1} << root_size_) - 1;
    const std::int64_t x0 = std::max<std::int64_t>(std::int64_t{box.x0} - box_.x0, 0);
    const std::int64_t y0 = std::max<std::int64_t>(std::int64_t{box.y0} - box_.y0, 0);
    const std::int64_t x1 = std::min<std::int64_t>(std::int64_t{box.x1} - box_.x0, root_last);
    const std::int64_t y1 = std::min<std::int64_t>(std::int64_t{box.y1} - box_.y0, root_last);
    if (x0 > x1 || y0 > y1 || !enter(0)) return true;
    const Window window{std::uint32_t(x0), std::uint32_t(y0), std::uint32_t(x1), std::uint32_t(y1)};
    return visit_window(0, window, (std::uint64_t{1} << root_size_) - 1, enter, visit);
  }

 private:
  class Builder;
  /// A box in the coordinates of a node, clipped to it.
  struct Window {
    std::uint32_t x0, y0, x1, y1;
  };

  template <class Enter, class Visit>
  bool visit_window(std::uint32_t index, const Window& w, std::uint64_t last, Enter& enter,
                    Visit& visit) const {
    const Node& node = nodes_[index];
    if (!visit(node)) return false;
    if (node.children == 0) return true;
    const std::uint64_t child_last = last >> node.fan_out;
    const int shift = node.child_shift;
    for (std::uint32_t row = w.y0 >> shift; row <= w.y1 >> shift; ++row) {
      for (std::uint32_t column = w.x0 >> shift; column <= w.x1 >> shift; ++column) {
        const std::uint32_t child = node.children + (row << node.fan_out) + column;
        if (!enter(child)) continue;
        const auto low = [&](std::uint32_t v, std::uint32_t cell) {
          return v >> shift == cell ? std::uint32_t(v & child_last) : 0;
        };
        const auto high = [&](std::uint32_t v, std::uint32_t cell) {
          return v >> shift == cell ? std::uint32_t(v & child_last) : std::uint32_t(child_last);
        };
        const Window inner{low(w.x0, column), low(w.y0, row), high(w.x1, column), high(w.y1, row)};
        if (!visit_window(child, inner, child_last, enter, visit)) return false;
      }
    }
    return true;
  }

  const std::vector<Caster>& casters_;
  Box box_{0, 0, -1, -1};
  int root_size_ = 0;
  std::vector<Node> nodes_;
  std::vector<Ref> refs_;
  std::vector<Cover> covers_;
};

}  // namespace kagesen
