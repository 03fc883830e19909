#include "bench/baselines/marching_cubes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "bench/baselines/cube_cases.h"
#include "bench/baselines/narrow_band.h"
#include "geometry/error.h"
#include "geometry/glued_triangles.h"

namespace morskin::baselines {

namespace {

using geometry::no_index;
constexpr int max_levels = 20;

/// The grid's corners seen so far, numbered in the order they came, by open addressing.
class CornerNumbers {
 public:
  /// The number of a corner; a new one has the number size() had.
  std::uint32_t of(const GridIndex& p) {
    if (2 * keys_.size() >= slots_.size()) grow();
    const std::uint64_t key = key_of(p);
    std::size_t slot = slot_of(key);
    while (slots_[slot] != no_index && keys_[slots_[slot]] != key) slot = (slot + 1) & mask();
    if (slots_[slot] == no_index) {
      slots_[slot] = static_cast<std::uint32_t>(keys_.size());
      keys_.push_back(key);
    }
    return slots_[slot];
  }
  std::size_t size() const { return keys_.size(); }

 private:
  static std::uint64_t key_of(const GridIndex& p) {
    return p[0] | std::uint64_t{p[1]} << (max_levels + 1) |
           std::uint64_t{p[2]} << 2 * (max_levels + 1);
  }
  std::size_t mask() const { return slots_.size() - 1; }
  /// Fibonacci hashing: the high bits of the product, as many as the table needs.
  std::size_t slot_of(std::uint64_t key) const {
    return (key * 0x9E3779B97F4A7C15U) >> (64 - std::bit_width(mask()));
  }
  void grow() {
    slots_.assign(std::max<std::size_t>(1024, 2 * slots_.size()), no_index);
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      std::size_t slot = slot_of(keys_[i]);
      while (slots_[slot] != no_index) slot = (slot + 1) & mask();
      slots_[slot] = static_cast<std::uint32_t>(i);
    }
  }

  std::vector<std::uint64_t> keys_;
  std::vector<std::uint32_t> slots_;  // a power of two of them
};

/// The mesh as it grows, cell by cell.
class March {
 public:
  March(const skin::SkinSurface& skin, const Grid& grid) : skin_(skin), grid_(grid) {}

  GridMesh run() && {
    for_each_cell_near_skin(skin_, grid_,
                            [this](const GridIndex& index, CellId near) { visit(index, near); });
    result_.corners = samples_.size();
    return std::move(result_);
  }

 private:
  void visit(const GridIndex& index, CellId near) {
    ++result_.grid_cells;
    std::array<std::uint32_t, 8> corners;
    std::size_t inside = 0;
    for (std::uint32_t c = 0; c < 8; ++c) {
      corners[c] = corner({index[0] + (c & 1), index[1] + (c >> 1 & 1), index[2] + (c >> 2)}, near);
      near = samples_[corners[c]].cell;
      inside |= std::size_t{samples_[corners[c]].value < 0} << c;
    }
    const CubeCase& found = cube_cases[inside];
    for (std::size_t t = 0; t < found.count; ++t) {
      std::array<std::uint32_t, 3> triangle;
      for (std::size_t k = 0; k < 3; ++k)
        triangle[k] = vertex(index, corners, found.triangles[t][k]);
      result_.mesh.triangles.push_back(triangle);
    }
  }

  std::uint32_t corner(const GridIndex& index, CellId near) {
    const std::uint32_t number = numbers_.of(index);
    if (number == samples_.size()) {
      samples_.push_back(sample(skin_, grid_.at(index), near));
      vertices_.push_back({no_index, no_index, no_index});
    }
    return number;
  }

  /// The vertex on a crossed edge of a cell.
  std::uint32_t vertex(const GridIndex& index, const std::array<std::uint32_t, 8>& corners,
                       std::size_t edge) {
    const auto [low, axis] = cube_edge(edge);
    std::uint32_t& v = vertices_[corners[low]][axis];
    if (v == no_index) {
      v = static_cast<std::uint32_t>(result_.cells.size());
      const GridIndex from{index[0] + (low & 1U), index[1] + (low >> 1 & 1U),
                           index[2] + (low >> 2 & 1U)};
      cross(from, axis, samples_[corners[low]], samples_[corners[low | 1U << axis]]);
    }
    return v;
  }

  /// Adds the point where a grid edge crosses the skin: from a linear guess by Newton's steps, by
  /// halves where they leave the part of the edge whose ends are on different sides.
  void cross(const GridIndex& from, std::size_t axis, const Sample& a, const Sample& b) {
    Point x = grid_.at(from);
    const double start = x[static_cast<Eigen::Index>(axis)];
    double low = 0, high = grid_.step;
    double along = high * a.value / (a.value - b.value);
    CellId cell = std::abs(a.value) < std::abs(b.value) ? a.cell : b.cell;
    for (;;) {
      x[static_cast<Eigen::Index>(axis)] = start + along;
      const Sample s = sample(skin_, x, cell);
      cell = s.cell;
      if (std::abs(s.value) <= skin_.residual_bound(s.length_scale)) break;
      ((s.value < 0) == (a.value < 0) ? low : high) = along;
      const geometry::Vector n = skin_.complex().patch(cell).half_gradient(x);
      const double slope = 2 * n[static_cast<Eigen::Index>(axis)];
      const double middle = 0.5 * (low + high);
      if (start + middle == start + low || start + middle == start + high) break;  // rounding
      const double next = along - s.value / slope;
      along = next > low && next < high ? next : middle;
    }
    result_.mesh.positions.push_back(x);
    result_.cells.push_back(cell);
  }

  const skin::SkinSurface& skin_;
  const Grid grid_;
  CornerNumbers numbers_;
  std::vector<Sample> samples_;                         // by corner
  std::vector<std::array<std::uint32_t, 3>> vertices_;  // by corner, on its edge along each axis
  GridMesh result_;
};

}  // namespace

Grid grid_over(const skin::SkinSurface& skin, double step) {
  Point low = Point::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const geometry::WeightedPoint& p : skin.points()) {
    if (!(p.weight > 0)) continue;
    low = low.cwiseMin((p.position.array() - std::sqrt(p.weight)).matrix());
    high = high.cwiseMax((p.position.array() + std::sqrt(p.weight)).matrix());
  }
  // A cell more at each end, and uneven shares of one, so that the corners keep off the planes of
  // symmetry and the round numbers of made-up molecules.
  const Point origin = low - step * Point(1.381966, 1.445042, 1.301938);
  const double cells = (high - origin).maxCoeff() / step + 1;
  if (!(cells < std::ldexp(1.0, max_levels))) {
    throw geometry::LimitReached("the grid has more than 2^20 steps along an axis; make it wider");
  }
  return {origin, step, static_cast<int>(std::bit_width(static_cast<std::uint32_t>(cells)))};
}

GridMesh marching_cubes(const skin::SkinSurface& skin, double step) {
  return March(skin, grid_over(skin, step)).run();
}

double step_like_sweep(const skin::SkinSurface& skin, const certify::Sizing& sizing) {
  std::vector<double> radii;
  for (const geometry::WeightedPoint& p : skin.points()) {
    if (p.weight > 0) radii.push_back(std::sqrt(p.weight / 2));
  }
  const auto median = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::nth_element(radii.begin(), median, radii.end());
  const GridMesh coarse = marching_cubes(skin, *median / 4);
  double area = 0, integral = 0;
  for (const auto& [a, b, c] : coarse.mesh.triangles) {
    const auto& p = coarse.mesh.positions;
    const double size = (p[b] - p[a]).cross(p[c] - p[a]).norm() / 2;
    const Point middle = (p[a] + p[b] + p[c]) / 3;
    const double rho = sample(skin, middle, coarse.cells[a]).length_scale;
    area += size;
    integral += size / (rho * rho);
  }
  // A plane crosses |n_x| + |n_y| + |n_z| grid edges a square step, 3/2 on average over all
  // directions, and there are two triangles to a vertex. The sweep's share was measured: 1.31 to
  // 1.43 on the molecules of the paper's Table 1 in all three models, with the default constants.
  constexpr double grid_share = 3, sweep_share = 1.4;
  const certify::Sizing usual;
  const double coarser = sizing.edge_share() / usual.edge_share();
  const double triangles = sweep_share * integral / std::pow(usual.C * usual.Q * coarser, 2);
  return std::sqrt(grid_share * area / triangles);
}

morskin::Mesher marching_cubes_mesher(double step) {
  return [step](const morskin::PreparedSkin& skin, const morskin::MeshingOptions&,
                morskin::Observer&, const morskin::Run& run) {
    morskin::MethodResult result;
    run.stage("marching cubes", [&] {
      const GridMesh made = marching_cubes(skin.surface, step);
      result.mesh.surface = geometry::closed_mesh(made.cells.size(), made.mesh.triangles).mesh;
      for (std::size_t v = 0; v < made.cells.size(); ++v) {
        result.mesh.points[geometry::VertexId{v}] =
            skin.surface.at(made.mesh.positions[v], made.cells[v]);
      }
    });
    return result;
  };
}

}  // namespace morskin::baselines
