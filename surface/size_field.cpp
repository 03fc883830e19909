#include "surface/size_field.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

namespace morskin::surface {

namespace {

constexpr std::uint32_t max_leaf = 8;

}  // namespace

SizeField::SizeField(std::vector<Source> sources, double slope)
    : slope_(slope), sources_(std::move(sources)) {
  build();
  // What a superfluous source allows somewhere, the one that limits it there allows as well.
  std::vector<Source> kept;
  for (const Source& source : sources_) {
    if (limited(source.size, source.position) == source.size) kept.push_back(source);
  }
  sources_ = std::move(kept);
  build();
}

void SizeField::build() {
  nodes_.clear();
  if (!sources_.empty()) build(0, static_cast<std::uint32_t>(sources_.size()));
}

std::uint32_t SizeField::build(std::uint32_t first, std::uint32_t last) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  Node node{
      sources_[first].position, sources_[first].position, sources_[first].size, first, last, 0};
  for (std::uint32_t i = first + 1; i < last; ++i) {
    node.low = node.low.cwiseMin(sources_[i].position);
    node.high = node.high.cwiseMax(sources_[i].position);
    node.min_size = std::min(node.min_size, sources_[i].size);
  }
  nodes_.push_back(node);
  if (last - first <= max_leaf) return index;
  Eigen::Index axis = 0;
  (node.high - node.low).maxCoeff(&axis);
  const std::uint32_t middle = first + (last - first) / 2;
  const auto at = [&](std::uint32_t i) { return sources_.begin() + std::ptrdiff_t{i}; };
  const auto key = [&](const Source& s) {
    return std::tuple(s.position[axis], s.size, s.position.x(), s.position.y(), s.position.z());
  };
  std::nth_element(at(first), at(middle), at(last),
                   [&](const Source& s, const Source& t) { return key(s) < key(t); });
  build(first, middle);
  nodes_[index].right = build(middle, last);
  return index;
}

double SizeField::limited(double size, const Point& x) const {
  double least = size;
  if (!nodes_.empty() && bound(nodes_[0], x) < least) search(nodes_[0], x, least);
  return least;
}

double SizeField::bound(const Node& node, const Point& x) const {
  const geometry::Vector offset = (node.low - x).cwiseMax(x - node.high).cwiseMax(0.0);
  return node.min_size + slope_ * offset.norm();
}

void SizeField::search(const Node& node, const Point& x, double& least) const {
  if (node.right == 0) {
    for (std::uint32_t i = node.first; i < node.last; ++i) {
      least = std::min(least, sources_[i].size + slope_ * (sources_[i].position - x).norm());
    }
    return;
  }
  const Node &left = *(&node + 1), &right = nodes_[node.right];
  const double to_left = bound(left, x), to_right = bound(right, x);
  const bool is_left_first = to_left <= to_right;
  if (std::min(to_left, to_right) < least) search(is_left_first ? left : right, x, least);
  if (std::max(to_left, to_right) < least) search(is_left_first ? right : left, x, least);
}

}  // namespace morskin::surface
