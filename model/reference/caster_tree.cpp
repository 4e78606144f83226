#include "model/reference/caster_tree.h"

#include <cmath>
#include <utility>

namespace kagesen {
namespace {

constexpr std::size_t kLeafRefs = 16;  ///< a leaf with no more is not cut
constexpr int kMaxFanOut = 6;          ///< log2 of the children a row
constexpr std::size_t kGrowth = 4;     ///< refs a grid may make of one, by bounding boxes

/// Half-planes A x + B y + C >= 0 of a triangle, in the root's coordinates.
struct Outline {
  std::int64_t a[3], b[3], c[3];

  Outline(const Caster& caster, const Box& root) {
    const std::int64_t sign = doubled_area(caster) < 0 ? -1 : 1;
    for (int i = 0; i < 3; ++i) {
      const LightPoint& p = caster.vertex[i];
      const LightPoint& q = caster.vertex[(i + 1) % 3];
      a[i] = sign * (std::int64_t{p.y} - q.y);
      b[i] = sign * (std::int64_t{q.x} - p.x);
      c[i] = -a[i] * (std::int64_t{p.x} - root.x0) - b[i] * (std::int64_t{p.y} - root.y0);
    }
  }
  /// 0: apart from the closed square at (x, y), 1: may meet it, 2: covers it, edges clear of it.
  int meets(std::int64_t x, std::int64_t y, std::int64_t side) const {
    bool covers = true;
    for (int i = 0; i < 3; ++i) {
      const std::int64_t corner = a[i] * x + b[i] * y + c[i];
      const std::int64_t da = a[i] * side, db = b[i] * side;
      if (corner + std::max<std::int64_t>(da, 0) + std::max<std::int64_t>(db, 0) < 0) return 0;
      covers &= corner + std::min<std::int64_t>(da, 0) + std::min<std::int64_t>(db, 0) > 0;
    }
    return covers ? 2 : 1;
  }
};

}  // namespace

/// Builds level by level, so that when the memory limit is reached the tree is cut evenly.
class CasterTree::Builder {
 public:
  Builder(CasterTree& tree, Shape shape) : tree_(tree), casters_(tree.casters_), shape_(shape) {}

  void build() {
    sort_by_depth();
    if (level_refs_.empty()) {
      tree_.nodes_.emplace_back();
      return;
    }
    fit_root();
    budget_ = 12 * level_refs_.size() + (1u << 20);
    tree_.nodes_.emplace_back();
    level_.push_back({0, 0, std::uint32_t(level_refs_.size()), 0, 0, tree_.root_size_});
    while (!level_.empty()) {
      next_level_.clear();
      next_refs_.clear();
      for (const Pending& p : level_) {
        if (!cut(p)) make_leaf(p);
      }
      level_.swap(next_level_);
      level_refs_.swap(next_refs_);
    }
    for (Node& node : tree_.nodes_) {
      std::sort(tree_.covers_.begin() + node.covers_begin, tree_.covers_.begin() + node.covers_end,
                [](const Cover& p, const Cover& q) {
                  return std::pair(p.nearest, p.caster) < std::pair(q.nearest, q.caster);
                });
    }
    tree_.nodes_.shrink_to_fit();
    tree_.refs_.shrink_to_fit();
    tree_.covers_.shrink_to_fit();
  }

 private:
  struct Pending {
    std::uint32_t node, begin, end;  ///< its refs in level_refs_
    std::uint32_t x, y;              ///< corner, units from the root's
    int size;                        ///< log2 of the side
  };
  struct CellRange {
    std::uint32_t x0, y0, x1, y1;  ///< inclusive
    std::uint64_t cells() const { return std::uint64_t{x1 - x0 + 1} * (y1 - y0 + 1); }
  };

  /// Grids keep the order of their refs, so one sort at the start serves every list.
  void sort_by_depth() {
    std::vector<std::uint64_t> keys;
    keys.reserve(casters_.size());
    for (std::uint32_t i = 0; i < casters_.size(); ++i) {
      if (shape_ == Shape::kOutline && doubled_area(casters_[i]) == 0) continue;
      keys.push_back(std::uint64_t{nearest_depth(casters_[i])} << 32 | i);
    }
    std::sort(keys.begin(), keys.end());
    level_refs_.assign(keys.begin(), keys.end());
  }

  void fit_root() {
    Box box = bounding_box(casters_[level_refs_[0]]);
    for (std::uint32_t i : level_refs_) {
      const Box b = bounding_box(casters_[i]);
      box = {std::min(box.x0, b.x0), std::min(box.y0, b.y0), std::max(box.x1, b.x1),
             std::max(box.y1, b.y1)};
    }
    const std::int64_t extent =
        std::max(std::int64_t{box.x1} - box.x0, std::int64_t{box.y1} - box.y0);
    while ((std::int64_t{1} << tree_.root_size_) <= extent) ++tree_.root_size_;
    tree_.box_ = box;
  }

  /// The children of p that the caster's bounding box meets.
  CellRange cells_of(const Caster& c, const Pending& p, int shift) const {
    const Box b = bounding_box(c);
    const std::int64_t last = (std::int64_t{1} << p.size) - 1;
    auto cell = [&](std::int64_t v, std::int64_t origin, std::uint32_t corner) {
      return std::uint32_t(std::clamp<std::int64_t>(v - origin - corner, 0, last) >> shift);
    };
    const Box& root = tree_.box_;
    return {cell(b.x0, root.x0, p.x), cell(b.y0, root.y0, p.y), cell(b.x1, root.x0, p.x),
            cell(b.y1, root.y0, p.y)};
  }

  /// The finest grid that does not multiply the refs too much; 0: none.
  int choose_fan_out(const Pending& p) const {
    const std::uint64_t count = p.end - p.begin;
    int fan_out = std::min(kMaxFanOut, p.size);
    while (fan_out > 1 && (std::uint64_t{2} << (2 * fan_out)) > count) --fan_out;
    for (; fan_out > 1; --fan_out) {
      std::uint64_t cells = 0;
      for (std::uint32_t i = p.begin; i != p.end && cells <= kGrowth * count; ++i) {
        cells += cells_of(casters_[level_refs_[i]], p, p.size - fan_out).cells();
      }
      if (cells <= kGrowth * count) break;
    }
    return fan_out;
  }

  bool cut(const Pending& p) {
    const std::size_t count = p.end - p.begin;
    if (count <= kLeafRefs || spent_ > budget_) return false;
    const int fan_out = choose_fan_out(p);
    if (fan_out == 0) return false;
    const int shift = p.size - fan_out;
    const std::size_t children = std::size_t{1} << (2 * fan_out);
    meeting_.clear();
    covering_.clear();
    for (std::uint32_t i = p.begin; i != p.end; ++i) distribute(p, level_refs_[i], shift, fan_out);
    // Casters that all meet every child gain nothing from a finer grid.
    if (meeting_.size() * 10 >= children * count * 9) return false;

    const auto first = std::uint32_t(tree_.nodes_.size());
    Node& node = tree_.nodes_[p.node];
    node.children = first;
    node.child_shift = std::uint8_t(shift);
    node.fan_out = std::uint8_t(fan_out);
    tree_.nodes_.resize(first + children);
    place_refs(p, first, shift, fan_out);
    place_covers(first, children);
    spent_ += meeting_.size() + 2 * covering_.size();
    return true;
  }

  void distribute(const Pending& p, std::uint32_t index, int shift, int fan_out) {
    const Caster& c = casters_[index];
    const CellRange range = cells_of(c, p, shift);
    if (range.cells() == 1) {
      meeting_.emplace_back((range.y0 << fan_out) + range.x0, index);
      return;
    }
    const std::int64_t side = std::int64_t{1} << shift;
    const Outline outline(c, tree_.box_);
    const Box b = bounding_box(c);
    for (std::uint32_t row = range.y0; row <= range.y1; ++row) {
      for (std::uint32_t column = range.x0; column <= range.x1; ++column) {
        const std::int64_t x = p.x + column * side, y = p.y + row * side;
        const std::uint32_t cell = (row << fan_out) + column;
        const int met =
            shape_ == Shape::kOutline ? outline.meets(x, y, side) : box_meets(b, x, y, side);
        if (met == 1) meeting_.emplace_back(cell, index);
        if (met == 2) covering_.emplace_back(cell, cover(c, index, x, y, side));
      }
    }
  }

  int box_meets(const Box& b, std::int64_t x, std::int64_t y, std::int64_t side) const {
    x += tree_.box_.x0;
    y += tree_.box_.y0;
    return b.x0 <= x && x + side <= b.x1 && b.y0 <= y && y + side <= b.y1 ? 2 : 1;
  }

  /// Bounds of a covering caster's depth over a square, from the square's corners.
  Cover cover(const Caster& c, std::uint32_t index, std::int64_t x, std::int64_t y,
              std::int64_t side) const {
    Cover result{nearest_depth(c), farthest_depth(c), index, c.object};
    if (shape_ == Shape::kBox) return result;
    x += tree_.box_.x0;
    y += tree_.box_.y0;
    double low = result.farthest, high = result.nearest;
    for (int corner = 0; corner < 4; ++corner) {
      const auto cx = std::int32_t(x + (corner & 1) * side),
                 cy = std::int32_t(y + (corner >> 1) * side);
      const double depth = plane_depth(c, weights_at(c, cx, cy));
      low = std::min(low, depth);
      high = std::max(high, depth);
    }
    // One depth unit of slack is far more than the rounding of plane_depth.
    result.nearest = std::max(result.nearest, std::uint32_t(std::max(low - 1, 0.0)));
    result.farthest = std::min(result.farthest, std::uint32_t(std::ceil(high) + 1));
    return result;
  }

  void place_refs(const Pending& p, std::uint32_t first, int shift, int fan_out) {
    const std::size_t children = std::size_t{1} << (2 * fan_out);
    counts_.assign(children + 1, 0);
    for (const auto& [cell, index] : meeting_) ++counts_[cell + 1];
    const auto base = std::uint32_t(next_refs_.size());
    for (std::size_t i = 0; i < children; ++i) {
      counts_[i + 1] += counts_[i];
      const std::uint32_t x = p.x + (std::uint32_t(i & ((1u << fan_out) - 1)) << shift);
      const std::uint32_t y = p.y + (std::uint32_t(i >> fan_out) << shift);
      if (counts_[i + 1] != counts_[i]) {
        next_level_.push_back(
            {std::uint32_t(first + i), base + counts_[i], base + counts_[i + 1], x, y, shift});
      }
    }
    next_refs_.resize(base + meeting_.size());
    for (const auto& [cell, index] : meeting_) next_refs_[base + counts_[cell]++] = index;
  }

  void place_covers(std::uint32_t first, std::size_t children) {
    counts_.assign(children + 1, 0);
    for (const auto& [cell, c] : covering_) ++counts_[cell + 1];
    const auto base = std::uint32_t(tree_.covers_.size());
    for (std::size_t i = 0; i < children; ++i) {
      counts_[i + 1] += counts_[i];
      tree_.nodes_[first + i].covers_begin = base + counts_[i];
      tree_.nodes_[first + i].covers_end = base + counts_[i + 1];
    }
    tree_.covers_.resize(base + covering_.size());
    for (const auto& [cell, c] : covering_) tree_.covers_[base + counts_[cell]++] = c;
  }

  void make_leaf(const Pending& p) {
    Node& node = tree_.nodes_[p.node];
    node.refs_begin = std::uint32_t(tree_.refs_.size());
    for (std::uint32_t i = p.begin; i != p.end; ++i) {
      tree_.refs_.push_back({nearest_depth(casters_[level_refs_[i]]), level_refs_[i]});
    }
    node.refs_end = std::uint32_t(tree_.refs_.size());
  }

  CasterTree& tree_;
  const std::vector<Caster>& casters_;
  const Shape shape_;
  std::size_t budget_ = 0, spent_ = 0;  ///< in refs
  std::vector<Pending> level_, next_level_;
  std::vector<std::uint32_t> level_refs_, next_refs_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> meeting_;  ///< child, caster
  std::vector<std::pair<std::uint32_t, Cover>> covering_;         ///< child, caster
  std::vector<std::uint32_t> counts_;
};

CasterTree::CasterTree(const std::vector<Caster>& casters, Shape shape) : casters_(casters) {
  Builder(*this, shape).build();
}

std::uint64_t CasterTree::bytes() const {
  return nodes_.capacity() * sizeof(Node) + refs_.capacity() * sizeof(Ref) +
         covers_.capacity() * sizeof(Cover);
}

}  // namespace kagesen
