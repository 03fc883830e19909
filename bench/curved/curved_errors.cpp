// How far curved triangles are from the skin, by the number of its patches that they lie over, and
// for two choices of the nodes in edges. Prints a table, tab-separated: papers/second-order.md.
//
//     morskin_curved_errors FILE|ball C
//
// Each curved triangle is projected onto the skin at the points of a grid; so the projections tile
// the skin, and the area of each is what its triangle ought to have.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <set>
#include <string>

#include "certify/curved_mesh.h"
#include "geometry/error.h"
#include "morskin/pipeline.h"
#include "morskin/second_order.h"
#include "skin/model.h"
#include "skin/molecule_files.h"

using namespace morskin;
using certify::CurvedTriangle;
using geometry::Point;
using geometry::Vector;

namespace {

constexpr std::size_t grid = 16;  ///< intervals of a side, even

/// Of triangles, summed.
struct Errors {
  std::size_t triangles = 0;
  double exact = 0, flat = 0, curved = 0;  ///< areas, Angstrom^2
  double distance = 0, squared_angle = 0;  ///< from the skin, means times area

  Errors& operator+=(const Errors& other) {
    triangles += other.triangles;
    exact += other.exact;
    flat += other.flat;
    curved += other.curved;
    distance += other.distance;
    squared_angle += other.squared_angle;
    return *this;
  }
};

double area(const Point& a, const Point& b, const Point& c) {
  return (b - a).cross(c - a).norm() / 2;
}

/// x(u, v), and x_u x x_v.
struct Sample {
  Point position;
  Vector normal;
};

Sample sample(const CurvedTriangle& nodes, double u, double v) {
  const std::array l{1 - u - v, u, v};
  Sample result{Point::Zero(), {}};
  Vector along_u = Vector::Zero(), along_v = Vector::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const auto du = [](std::size_t k) { return k == 0 ? -1.0 : k == 1 ? 1.0 : 0.0; };
    const auto dv = [](std::size_t k) { return k == 0 ? -1.0 : k == 2 ? 1.0 : 0.0; };
    result.position += l[i] * (2 * l[i] - 1) * nodes[i] + 4 * l[i] * l[j] * nodes[3 + i];
    along_u += (4 * l[i] - 1) * du(i) * nodes[i] + 4 * (du(i) * l[j] + l[i] * du(j)) * nodes[3 + i];
    along_v += (4 * l[i] - 1) * dv(i) * nodes[i] + 4 * (dv(i) * l[j] + l[i] * dv(j)) * nodes[3 + i];
  }
  result.normal = along_u.cross(along_v);
  return result;
}

/// The points of the skin under the grid, [i][j] with u = i / grid and v = j / grid.
using Projection = std::array<std::array<Point, grid + 1>, grid + 1>;

/// The area under it, with triangles of so many intervals.
double area_under(const Projection& x, std::size_t step) {
  double sum = 0;
  for (std::size_t i = 0; i < grid; i += step) {
    for (std::size_t j = 0; i + j < grid; j += step) {
      sum += area(x[i][j], x[i + step][j], x[i][j + step]);
      if (i + j + step < grid) sum += area(x[i + step][j], x[i + step][j + step], x[i][j + step]);
    }
  }
  return sum;
}

/// Of one triangle. @param patches  where to put how many it lies over
Errors errors_of(const CurvedTriangle& nodes, const surface::Surface& skin, geometry::CellId hint,
                 std::size_t& patches) {
  Projection under;
  std::set<geometry::CellId> cells;
  double distance = 0, squared_angle = 0;
  std::size_t samples = 0;
  for (std::size_t i = 0; i <= grid; ++i) {
    for (std::size_t j = 0; i + j <= grid; ++j, ++samples) {
      const Sample x = sample(nodes, static_cast<double>(i) / grid, static_cast<double>(j) / grid);
      const auto foot = skin.project(x.position, hint);
      if (!foot) throw geometry::RefusedInput("a point of a curved triangle is far from the skin");
      under[i][j] = foot->position;
      hint = foot->cell;
      if (i > 0 && j > 0 && i + j < grid) cells.insert(foot->cell);
      distance += (foot->position - x.position).norm();
      const double sine = x.normal.cross(foot->normal).norm(), cosine = x.normal.dot(foot->normal);
      squared_angle += std::pow(std::atan2(sine, cosine), 2);
    }
  }
  patches = cells.size();
  const double fine = area_under(under, 1), coarse = area_under(under, 2);
  const double exact = fine + (fine - coarse) / 3;  // the error goes with the square of the step
  const double share = exact / static_cast<double>(samples);
  return {1,
          exact,
          area(nodes[0], nodes[1], nodes[2]),
          certify::curved_area(nodes),
          distance * share,
          squared_angle * share};
}

/// Those over one patch, over two, over more, and all.
using ByPatches = std::array<Errors, 4>;

ByPatches errors_of(const SecondOrder& curved, const surface::Surface& skin) {
  ByPatches result;
  for (const geometry::SecondOrderTriangle& triangle : curved.mesh.triangles) {
    const CurvedTriangle nodes = certify::nodes_of(curved.mesh, triangle);
    std::size_t patches = 0;
    const Errors errors = errors_of(nodes, skin, curved.cells[triangle[0]], patches);
    result[std::min<std::size_t>(patches, 3) - 1] += errors;
    result[3] += errors;
  }
  return result;
}

/// The same triangles with the nodes where the middles of their edges lead.
SecondOrder centered(SecondOrder curved, const surface::Surface& skin) {
  for (const geometry::SecondOrderTriangle& t : curved.mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Point middle = (curved.mesh.nodes[t[k]] + curved.mesh.nodes[t[(k + 1) % 3]]) / 2;
      const auto node = skin.project(middle, curved.cells[t[k]]);
      if (!node) throw geometry::RefusedInput("the middle of an edge does not reach the skin");
      curved.mesh.nodes[t[3 + k]] = node->position;
    }
  }
  return curved;
}

PreparedSkin skin_of(const std::string& file) {
  if (file == "ball") return prepare_skin({{Point(0, 0, 0), 2}});
  return prepare_skin(
      skin::weighted_points(skin::read_molecule(file), skin::Model::Vdw, /*probe=*/1.4));
}

void print(const std::string& name, const ByPatches& all) {
  constexpr std::array kinds{"1", "2", "more", "all"};
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Errors& e = all[k];
    if (e.triangles == 0) continue;
    const double angle_deg = std::sqrt(e.squared_angle / e.exact) * 180 / M_PI;
    std::cout << name << '\t' << kinds[k] << '\t' << e.triangles << '\t' << e.exact << '\t'
              << e.exact - e.flat << '\t' << e.exact - e.curved << '\t' << e.distance / e.exact
              << '\t' << angle_deg << '\n';
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: morskin_curved_errors FILE|ball C\n";
    return 2;
  }
  const double C = std::atof(argv[2]);
  const PreparedSkin skin = skin_of(argv[1]);
  const MeshResult made = make_mesh(skin, {.sizing = {C, certify::Sizing::quality_for(C)}});
  const SecondOrder curved = second_order(skin.surface, made.mesh, made.cells);
  std::cout.precision(12);
  print("middle", errors_of(centered(curved, skin.surface), skin.surface));
  print("parabola", errors_of(curved, skin.surface));
}
