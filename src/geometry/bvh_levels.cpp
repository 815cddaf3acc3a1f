#include "geometry/bvh_levels.hpp"

#include <algorithm>
#include <utility>

#include "base/parallel_for.hpp"

namespace penumbra {
namespace {

constexpr std::uint32_t subtree_size = 1 << 14;  // up to here a range is the work of one thread; its items fit a cache

// A part of a range, for one thread.
struct Piece {
  std::size_t range;  // its index in the level
  std::span<BvhItem> items;
  Bins bins;
  FloatBounds bounds;
  std::uint32_t left_count = 0;
  Sides to{};
  std::array<FloatBounds, 2> centers;  // of the items on either side
};

struct OpenRange {
  BvhRange range;
  std::uint32_t parent;
  int side;
  BinGrid grid;
  BinnedSplit split;
  std::uint32_t middle = 0;
  std::array<FloatBounds, 2> centers;
};

class LevelSplitter {
 public:
  LevelSplitter(std::span<BvhItem> items, std::span<BvhItem> spare, int threads)
      : items_(items.data()), spare_(spare.data()), threads_(threads) {
    add(whole(items), 0, 0);
    while (!level_.empty()) split_level();
    std::ranges::sort(result_.subtrees, {}, [](const Subtree& subtree) { return subtree.range.begin; });
  }

  UpperLevels result() { return std::move(result_); }

 private:
  BvhRange whole(std::span<BvhItem> items) {
    BvhRange range{0, static_cast<std::uint32_t>(items.size()), 0, {}, {}};
    cut(range, 0);
    for_pieces([](Piece& piece) {
      for (const BvhItem& item : piece.items) {
        piece.bounds.include(item.bounds());
        piece.centers[0].include(center_of(item.bounds()));
      }
    });
    for (const Piece& piece : pieces_) {
      range.bounds.include(piece.bounds);
      range.centers.include(piece.centers[0]);
    }
    result_.bounds = range.bounds;
    return range;
  }

  void add(const BvhRange& range, std::uint32_t parent, int side) {
    if (range.count() <= subtree_size || range.depth >= balanced_below_depth) {
      result_.subtrees.push_back({range, parent, side, items_, spare_});
    } else {
      level_.push_back({range, parent, side, BinGrid(range.centers), {}, 0, {}});
    }
  }

  void split_level() {
    find_splits();
    std::erase_if(level_, [&](const OpenRange& open) {
      if (open.split.axis < 0) result_.subtrees.push_back({open.range, open.parent, open.side, items_, spare_});
      return open.split.axis < 0;
    });
    deal_items();
    std::swap(items_, spare_);
    for (const OpenRange& open : std::exchange(level_, {})) add_node(open);
  }

  void find_splits() {
    cut_level();
    for_pieces([&](Piece& piece) {
      const BinGrid& grid = level_[piece.range].grid;
      piece.bins.clear();
      piece.bins.add(piece.items, grid);
    });
    auto piece = pieces_.begin();
    Bins bins;
    for (std::size_t i = 0; i < level_.size(); i++) {
      bins.clear();
      for (; piece != pieces_.end() && piece->range == i; piece++) bins.add(piece->bins);
      level_[i].split = bins.best_split(inverse_extent(level_[i].range.bounds));
    }
  }

  void deal_items() {
    cut_level();
    for_pieces([&](Piece& piece) {
      const OpenRange& open = level_[piece.range];
      piece.left_count = static_cast<std::uint32_t>(std::ranges::count_if(piece.items, [&](const BvhItem& item) {
        return !open.split.goes_right(open.grid.bins_of(center_of(item.bounds())));
      }));
    });
    for (OpenRange& open : level_) open.middle = open.range.begin;
    for (const Piece& piece : pieces_) level_[piece.range].middle += piece.left_count;
    Sides to{};
    for (Piece& piece : pieces_) {
      const OpenRange& open = level_[piece.range];
      if (piece.items.data() == items_ + open.range.begin) to = {spare_ + open.range.begin, spare_ + open.middle};
      piece.to = to;
      to.left += piece.left_count;
      to.right += piece.items.size() - piece.left_count;
    }
    for_pieces([&](Piece& piece) {
      const OpenRange& open = level_[piece.range];
      piece.centers = deal(piece.items, open.grid, open.split, piece.to);
    });
    for (const Piece& piece : pieces_) {
      for (std::size_t side = 0; side < 2; side++) level_[piece.range].centers[side].include(piece.centers[side]);
    }
  }

  void add_node(const OpenRange& open) {
    const auto index = static_cast<NodeReference>(result_.nodes.size());
    if (index > 0) result_.nodes[open.parent].child[open.side] = index;
    Halves halves = halves_of(open.range, open.middle, open.split);
    result_.nodes.push_back(node_with(halves.left.bounds, halves.right.bounds));
    halves.left.centers = open.centers[0];
    halves.right.centers = open.centers[1];
    add(halves.left, index, 0);
    add(halves.right, index, 1);
  }

  void cut_level() {
    pieces_.clear();
    for (std::size_t i = 0; i < level_.size(); i++) cut(level_[i].range, i);
  }
  void cut(const BvhRange& range, std::size_t index) {
    for (std::uint32_t begin = range.begin; begin < range.end; begin += subtree_size) {
      Piece& piece = pieces_.emplace_back();
      piece.range = index;
      piece.items = {items_ + begin, std::min(range.end - begin, subtree_size)};
    }
  }

  template <class Work>
  void for_pieces(const Work& work) {
    parallel_for(pieces_.size(), threads_, [&](std::size_t i) { work(pieces_[i]); });
  }

  BvhItem* items_;
  BvhItem* spare_;
  int threads_;
  std::vector<OpenRange> level_;
  std::vector<Piece> pieces_;
  UpperLevels result_;
};

}  // namespace

UpperLevels split_upper_levels(std::span<BvhItem> items, std::span<BvhItem> spare, int threads) {
  return LevelSplitter(items, spare, threads).result();
}

}  // namespace penumbra
