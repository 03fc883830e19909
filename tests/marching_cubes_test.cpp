#include "bench/baselines/marching_cubes.h"

#include <bit>

#include "bench/baselines/cube_cases.h"
#include "bench/baselines/narrow_band.h"
#include "geometry/mesh_shape.h"
#include "geometry/surface_mesh.h"
#include "morskin/pipeline.h"
#include "tests/support/meshes.h"

using namespace morskin;
using namespace morskin::baselines;
using namespace morskin::support;

namespace {

constexpr std::size_t bit(std::size_t number, std::size_t place) { return number >> place & 1; }

std::size_t upper_end(CubeEdge edge) { return edge.corner | std::size_t{1} << edge.axis; }

geometry::Point position_of(std::size_t corner) {
  return geometry::Point(static_cast<double>(bit(corner, 0)), static_cast<double>(bit(corner, 1)),
                         static_cast<double>(bit(corner, 2)));
}
geometry::Point middle_of(CubeEdge edge) {
  return (position_of(edge.corner) + position_of(upper_end(edge))) / 2;
}

/// The faces of the cube that an edge lies on, a bit each.
std::size_t faces_of(std::size_t number) {
  const CubeEdge edge = cube_edge(number);
  std::size_t faces = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (axis != edge.axis) faces |= std::size_t{1} << (2 * axis + bit(edge.corner, axis));
  }
  return faces;
}

/// Directed sides of a case's triangles that have no partner in the case.
std::set<std::pair<std::size_t, std::size_t>> open_sides(const CubeCase& c) {
  std::set<std::pair<std::size_t, std::size_t>> open;
  for (std::size_t t = 0; t < c.count; ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t from = c.triangles[t][k], to = c.triangles[t][(k + 1) % 3];
      if (open.erase({to, from}) == 0) CHECK(open.insert({from, to}).second);
    }
  }
  return open;
}

PreparedSkin skin_of(std::string_view file, skin::Model model) {
  return prepare_skin(molecule(file, model));
}

certify::Certificate certificate(const PreparedSkin& skin, const GridMesh& made) {
  return certify::certify(made.mesh, skin.surface, skin.topology);
}

}  // namespace

TEST_CASE("a case's triangles use exactly the crossed edges of the cube") {
  for (std::size_t inside = 0; inside < 256; ++inside) {
    CAPTURE(inside);
    std::set<std::size_t> used, crossed;
    const CubeCase& c = cube_cases[inside];
    for (std::size_t t = 0; t < c.count; ++t)
      used.insert(c.triangles[t].begin(), c.triangles[t].end());
    for (std::size_t e = 0; e < cube_edge_count; ++e) {
      const CubeEdge edge = cube_edge(e);
      if (bit(inside, edge.corner) != bit(inside, upper_end(edge))) crossed.insert(e);
    }
    CHECK(used == crossed);
  }
}

TEST_CASE("a case's surface ends on the cube's faces only, and no cut lies on a face") {
  for (std::size_t inside = 0; inside < 256; ++inside) {
    CAPTURE(inside);
    const CubeCase& c = cube_cases[inside];
    const auto open = open_sides(c);
    for (const auto& [from, to] : open) {
      CHECK(std::popcount(faces_of(from) & faces_of(to)) == 1);
    }
    for (std::size_t t = 0; t < c.count; ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t from = c.triangles[t][k], to = c.triangles[t][(k + 1) % 3];
        const bool is_cut = !open.contains({from, to});
        CHECK((!is_cut || (faces_of(from) & faces_of(to)) == 0));
      }
    }
  }
}

TEST_CASE("two cubes with a face in common leave the same segments on it, oppositely directed") {
  // The face x = 1 of one cube is x = 0 of the next: y-edges 4 + i and z-edges 8 + i at x = 0 or 1.
  const auto segments = [](std::size_t inside, std::size_t face) {
    std::set<std::pair<std::size_t, std::size_t>> found;
    for (const auto& [from, to] : open_sides(cube_cases[inside])) {
      if ((faces_of(from) & faces_of(to)) != std::size_t{1} << face) continue;
      // What is left of an edge's number without its place along x.
      const auto without_x = [](std::size_t e) {
        const CubeEdge edge = cube_edge(e);
        return 8 * edge.axis + (edge.corner & 6U);
      };
      found.insert({without_x(from), without_x(to)});
    }
    return found;
  };
  for (std::size_t face_case = 0; face_case < 16; ++face_case) {
    CAPTURE(face_case);
    std::set<std::set<std::pair<std::size_t, std::size_t>>> left, right;
    for (std::size_t others = 0; others < 16; ++others) {
      std::size_t upper = 0, lower = 0;  // the face's corners at x = 1, at x = 0
      for (std::size_t k = 0; k < 4; ++k) {
        upper |= bit(face_case, k) << (2 * k + 1) | bit(others, k) << 2 * k;
        lower |= bit(face_case, k) << 2 * k | bit(others, k) << (2 * k + 1);
      }
      left.insert(segments(upper, 1));
      auto turned = segments(lower, 0);
      std::set<std::pair<std::size_t, std::size_t>> back;
      for (const auto& [from, to] : turned) back.insert({to, from});
      right.insert(back);
    }
    CHECK(left.size() == 1);
    CHECK(left == right);
  }
}

TEST_CASE("a single inside corner is cut off by a triangle that faces away from it") {
  for (std::size_t corner = 0; corner < 8; ++corner) {
    CAPTURE(corner);
    const CubeCase& c = cube_cases[std::size_t{1} << corner];
    REQUIRE(c.count == 1);
    const auto at = [&](std::size_t k) { return middle_of(cube_edge(c.triangles[0][k])); };
    const geometry::Vector normal = (at(1) - at(0)).cross(at(2) - at(0));
    CHECK(normal.dot(at(0) - position_of(corner)) > 0);
  }
}

TEST_CASE("no skin lies within the free distance of a point") {
  const PreparedSkin skin = skin_of("benzene.pdb", skin::Model::Paper);
  const Box box = box_of(skin.surface.points());
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    CAPTURE(i);
    const geometry::Point x = box.sample(random);
    const Sample s = sample(skin.surface, x, geometry::CellId{0U});
    const double radius = free_distance(s);
    for (int j = 0; j < 20; ++j) {
      const geometry::Point y = x + 0.999999 * radius * random.direction();
      CHECK((sample(skin.surface, y, s.cell).value < 0) == (s.value < 0));
    }
  }
}

TEST_CASE("every cell whose corners lie on both sides of the skin is visited, once") {
  const PreparedSkin skin = skin_of("benzene.pdb", skin::Model::Paper);
  const Grid grid = grid_over(skin.surface, 0.6);
  std::map<GridIndex, int> visits;
  for_each_cell_near_skin(skin.surface, grid,
                          [&](const GridIndex& p, geometry::CellId) { ++visits[p]; });
  const std::uint32_t width = std::uint32_t{1} << grid.levels;
  std::size_t crossed = 0;
  for (std::uint32_t x = 0; x < width; ++x) {
    for (std::uint32_t y = 0; y < width; ++y) {
      for (std::uint32_t z = 0; z < width; ++z) {
        int inside = 0;
        for (std::uint32_t c = 0; c < 8; ++c) {
          const geometry::Point p = grid.at({x + (c & 1), y + (c >> 1 & 1), z + (c >> 2)});
          inside += sample(skin.surface, p, geometry::CellId{0U}).value < 0;
        }
        if (inside == 0 || inside == 8) continue;
        ++crossed;
        CHECK(visits[{x, y, z}] == 1);
      }
    }
  }
  CHECK(crossed > 100);
  CHECK(visits.size() < 2 * crossed);
}

TEST_CASE("marching cubes gives closed oriented manifolds with every vertex on the skin") {
  for_molecules({"two_balls.xyzr", "cube8.xyzr", "ring12.xyzr", "shell_hollow.xyzr", "benzene.pdb",
                 "c60.xyz", "5tmn_ligand.pdb"},
                [](const WeightedPoints& balls) {
                  const PreparedSkin skin = prepare_skin(balls);
                  for (const double step : {0.9, 0.31}) {
                    CAPTURE(step);
                    const GridMesh made = marching_cubes(skin.surface, step);
                    const certify::Certificate c = certificate(skin, made);
                    CHECK(c.broken_by(certify::Claim::Manifold) == "");
                    CHECK(c.broken_by(certify::Claim::OnSkin) == "");
                    CHECK(c.volume > 0);
                    REQUIRE(made.cells.size() == made.mesh.positions.size());
                  }
                });
}

TEST_CASE("a fine grid gives the skin's topology, but no quality and no certificate") {
  for (const char* file : {"two_balls.xyzr", "ring12.xyzr", "shell_hollow.xyzr", "caffeine.xyz"}) {
    CAPTURE(file);
    const PreparedSkin skin = skin_of(file, skin::Model::Paper);
    const certify::Certificate c = certificate(skin, marching_cubes(skin.surface, 0.12));
    CHECK(c.broken_by(certify::Claim::Counts) == "");
    CHECK_FALSE(c.certified);
    CHECK(c.violations_L > 0);
    CHECK(c.min_angle_deg < 5);
  }
}

TEST_CASE("area and volume of a ball come nearer with the square of the step") {
  const PreparedSkin skin = prepare_skin({ball(0.1, -0.2, 0.3, 1.5)});
  const double area = 4 * M_PI * 1.5 * 1.5, volume = area * 1.5 / 3;
  const auto miss = [&](double step) {
    const certify::Certificate c = certificate(skin, marching_cubes(skin.surface, step));
    CHECK(c.euler_characteristic == 2);
    return std::pair{area - c.area, volume - c.volume};
  };
  const auto [wide_area, wide_volume] = miss(0.2);
  const auto [narrow_area, narrow_volume] = miss(0.05);
  CHECK(wide_area / narrow_area == doctest::Approx(16).epsilon(0.1));
  CHECK(wide_volume / narrow_volume == doctest::Approx(16).epsilon(0.1));
}

TEST_CASE("marching cubes gives the same mesh twice") {
  const PreparedSkin skin = skin_of("5tmn_ligand.pdb", skin::Model::Paper);
  CHECK(marching_cubes(skin.surface, 0.3).mesh == marching_cubes(skin.surface, 0.3).mesh);
}

TEST_CASE("the grid step chosen makes as many triangles as the sweep, within a fifth") {
  const auto triangles = [](const auto& made) {
    return static_cast<double>(made.mesh.triangles.size());
  };
  for_molecules({"two_balls.xyzr", "ring12.xyzr", "caffeine.xyz", "5tmn_ligand.pdb"},
                [&](const WeightedPoints& balls) {
                  const PreparedSkin skin = prepare_skin(balls);
                  for (const double C : {0.2, 0.08, 0.05}) {
                    CAPTURE(C);
                    const certify::Sizing sizing{.C = C, .Q = certify::Sizing::quality_for(C)};
                    const auto swept = make_mesh(skin, {.sizing = sizing, .has_safety_net = false});
                    const double step = step_like_sweep(skin.surface, sizing);
                    CHECK(triangles(marching_cubes(skin.surface, step)) / triangles(swept) ==
                          doctest::Approx(1).epsilon(0.2));
                  }
                });
}

TEST_CASE("a step so small that the grid has too many cells is refused") {
  const PreparedSkin skin = prepare_skin({ball(0, 0, 0, 1.5)});
  CHECK_THROWS_AS(marching_cubes(skin.surface, 1e-7), geometry::LimitReached);
}
