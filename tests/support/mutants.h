#pragma once

/// Meshes made wrong, or only other, at random: whatever a program, a file format or an enemy may
/// do to a good one.

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "certify/triangle_geometry.h"
#include "geometry/files/mesh_files.h"
#include "tests/support/mesh_part.h"
#include "tests/support/meshes.h"
#include "tests/support/wrong_meshes.h"

namespace morskin::support {

using geometry::IndexedMesh;
using geometry::Point;
using geometry::Vector;

/// The closed parts of a mesh; one, all of it, where it is no closed manifold.
inline std::vector<IndexedMesh> parts_of(const IndexedMesh& mesh) {
  const auto built = geometry::closed_mesh(mesh.positions.size(), mesh.triangles);
  if (built.defect) return {mesh};
  const geometry::Components components = geometry::components(built.mesh);
  std::vector<IndexedMesh> parts;
  for (std::size_t c = 0; c < components.count; ++c) {
    parts.push_back(mesh_part(mesh, [&](std::size_t t) { return components.of_triangle[t] == c; }));
  }
  return parts;
}

/// A mesh that changes at random, step by step.
class Mutant {
 public:
  /// @param skin, random  must outlive this
  Mutant(IndexedMesh good, const surface::Surface& skin, Random& random)
      : mesh(std::move(good)), skin_(skin), random_(random) {}

  IndexedMesh mesh;
  std::string history;

  struct Step {
    const char* name;
    void (Mutant::*change)();
  };
  /// Those that take the mesh by its parts come first: they need it closed.
  static const std::vector<Step>& steps();
  static constexpr std::size_t part_steps = 9;

  void change(const Step& step) {
    (this->*step.change)();
    history += (history.empty() ? "" : ", ") + std::string(step.name);
  }

 private:
  double small() { return std::pow(10.0, -random_.between(0.3, 10)); }
  /// Shares of the length scale that have been of interest.
  double offset() {
    constexpr std::array offsets{0.0, 0.9e-9, -0.9e-9, 1e-7, 1e-4, -1e-3, 0.03, -0.08};
    return offsets[random_.below(offsets.size())];
  }
  std::size_t some_vertex() { return random_.below(mesh.positions.size()); }
  std::array<std::uint32_t, 3> some_triangle() {
    return mesh.triangles[random_.below(mesh.triangles.size())];
  }
  Vector half_gradient(const Point& x) const {
    return skin_.enclose(x, skin_.locate(x, geometry::CellId{0U})).half_gradient;
  }
  void push(Point& x, double share) const { x += share * half_gradient(x); }
  void push_all(IndexedMesh& part, double share) const {
    for (Point& x : part.positions) push(x, share);
  }
  static Point centre_of(const IndexedMesh& part) {
    Point sum = Point::Zero();
    for (const Point& x : part.positions) sum += x;
    return sum / static_cast<double>(part.positions.size());
  }
  /// Replaces one part, or takes it away, and another now and then: so the number may stay right.
  template <class Change>
  void change_part(Change edit, bool drops_another) {
    std::vector<IndexedMesh> parts = parts_of(mesh);
    const std::size_t chosen = random_.below(parts.size());
    parts[chosen] = edit(parts[chosen]);
    const std::size_t dropped =
        drops_another && random_.below(2) == 0 ? random_.below(parts.size()) : chosen;
    mesh = {};
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (i == chosen || i != dropped) mesh = together(mesh, parts[i]);
    }
  }
  /// Cuts a triangle into three at its circumcentre, which is moved onto the skin and pushed off.
  void cut_at_circumcentre(IndexedMesh& part, std::size_t t, double share) const {
    const auto [a, b, c] = part.triangles[t];
    const auto& p = part.positions;
    Point centre = certify::circumcircle(p[a], p[b], p[c]).centre;
    if (const auto on = skin_.project(centre, geometry::CellId{0U})) centre = on->position;
    push(centre, share);
    cut(part, t, centre);
    const auto v = static_cast<std::uint32_t>(part.positions.size() - 1);
    part = begun_at(std::move(part), v);
  }

  void cover_twice() {
    change_part(
        [&](IndexedMesh part) {
          IndexedMesh other = part;
          push_all(part, offset());
          push_all(other, offset());
          if (random_.below(2) == 0) cut_at_circumcentre(part, 0, offset());
          if (random_.below(2) == 0)
            cut_at_circumcentre(other, other.triangles.size() / 2, offset());
          return together(part, other);
        },
        true);
  }
  void branch() {
    change_part(
        [&](const IndexedMesh& part) {
          IndexedMesh cover = double_cover(part);
          const double first = offset(), second = offset();
          for (std::size_t v = 0; v < cover.positions.size(); ++v) {
            push(cover.positions[v], v < part.positions.size() ? first : second);
          }
          if (random_.below(2) == 0)
            cut_at_circumcentre(cover, part.triangles.size() - 1, offset());
          if (random_.below(2) == 0)
            cut_at_circumcentre(cover, cover.triangles.size() - 1, offset());
          return cover;
        },
        true);
  }
  void wind() {
    change_part(
        [&](const IndexedMesh& part) {
          const std::uint32_t sheets = 2 + static_cast<std::uint32_t>(random_.below(2));
          IndexedMesh cover =
              wound_cover(part, sheets, centre_of(part), static_cast<int>(random_.below(3)));
          const std::size_t simple = part.positions.size();
          if (cover.positions.size() == simple) return double_cover(part);
          const std::array offsets{offset(), offset(), offset()};
          for (std::size_t v = 0; v < cover.positions.size(); ++v) {
            push(cover.positions[v], offsets[v / simple]);
          }
          return cover;
        },
        true);
  }
  void leave_out() {
    change_part([](const IndexedMesh&) { return IndexedMesh{}; }, false);
  }
  void swap_parts() {
    const std::vector<IndexedMesh> parts = parts_of(mesh);
    const Eigen::AngleAxisd turn(random_.between(0, 2 * M_PI), random_.direction());
    change_part(
        [&](const IndexedMesh& part) {
          IndexedMesh other = parts[random_.below(parts.size())];
          const Point here = centre_of(part), there = centre_of(other);
          for (Point& x : other.positions) x = here + turn * (x - there);
          return other;
        },
        false);
  }
  void turn_inside_out() { change_part(turned_inside_out, false); }
  void fill_inside_out() {
    change_part([](const IndexedMesh& part) { return together(part, turned_inside_out(part)); },
                true);
  }
  void bridge() {
    const std::size_t from = random_.below(mesh.triangles.size());
    const std::size_t to = random_.below(mesh.triangles.size());
    if (from != to) mesh = with_tube(std::move(mesh), from, to);
  }
  void slit_at_vertex() {
    const auto built = geometry::closed_mesh(mesh.positions.size(), mesh.triangles);
    if (built.defect) return;
    const geometry::HalfEdgeId h = random_half_edge(built.mesh, random_);
    const double rho = half_gradient(mesh.positions[built.mesh.origin(h).index()]).norm();
    mesh = slit(std::move(mesh), h, random_.below(100), small() * rho * random_.direction());
  }
  void fold() {
    const auto [a, b, c] = some_triangle();
    const Point middle = (mesh.positions[b] + mesh.positions[c]) / 2;
    const double share = random_.between(0, 2.5);
    mesh.positions[a] += share * (middle - mesh.positions[a]);
    if (const auto on = skin_.project(mesh.positions[a], geometry::CellId{0U})) {
      mesh.positions[a] = on->position;
    }
  }
  void flip() {
    for (std::size_t i = 1 + random_.below(4); i > 0; --i) {
      const auto built = geometry::closed_mesh(mesh.positions.size(), mesh.triangles);
      if (built.defect) return;
      const geometry::HalfEdgeId h = random_half_edge(built.mesh, random_);
      if (random_.below(8) != 0 && !can_flip(built.mesh, h)) continue;
      const geometry::HalfEdgeId twin = built.mesh.twin(h);
      const std::uint32_t a = built.mesh.origin(h).value, b = built.mesh.target(h).value;
      const std::uint32_t c = built.mesh.apex(h).value, d = built.mesh.apex(twin).value;
      mesh.triangles[geometry::SurfaceMesh::triangle(h).index()] = {a, d, c};
      mesh.triangles[geometry::SurfaceMesh::triangle(twin).index()] = {d, b, c};
    }
  }
  void insert_needle() {
    const std::size_t t = random_.below(mesh.triangles.size());
    const auto [a, b, c] = mesh.triangles[t];
    const double share = random_.below(2) == 0 ? small() : random_.uniform();
    const Point on_edge = mesh.positions[a] + share * (mesh.positions[b] - mesh.positions[a]);
    cut(mesh, t, on_edge + small() * (mesh.positions[c] - on_edge));
  }
  void scale() {
    const Point centre = random_.below(2) == 0 ? centre_of(mesh) : mesh.positions[some_vertex()];
    const double factor = 1 + (random_.below(2) == 0 ? 1 : -1) * small();
    for (Point& x : mesh.positions) x = centre + factor * (x - centre);
  }
  void shake() {
    const double share = small();
    for (Point& x : mesh.positions) x += share * half_gradient(x).norm() * random_.direction();
  }
  void round_to_floats() { mesh = geometry::in_single_precision(std::move(mesh)); }
  void round_to_decimals() {
    const double unit = small() * half_gradient(mesh.positions[some_vertex()]).norm();
    for (Point& x : mesh.positions) x = ((x / unit).array().round() * unit).matrix();
  }
  void push_vertices() {
    for (std::size_t i = 1 + random_.below(10); i > 0; --i) {
      push(mesh.positions[some_vertex()], offset());
    }
  }
  void contract() {
    const auto [a, b, c] = some_triangle();
    for (auto& t : mesh.triangles) std::ranges::replace(t, b, a);
    std::erase_if(mesh.triangles,
                  [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
    mesh = mesh_part(mesh, [](std::size_t) { return true; });
  }
  void pinch() {
    const auto a = static_cast<std::uint32_t>(some_vertex());
    const auto b = static_cast<std::uint32_t>(some_vertex());
    for (auto& t : mesh.triangles) std::ranges::replace(t, a, b);
    mesh = mesh_part(mesh, [](std::size_t) { return true; });
  }
  void spoil_coordinate() {
    using Limits = std::numeric_limits<double>;
    constexpr std::array bad{1e9,
                             1e160,
                             1e300,
                             -1e308,
                             Limits::min(),
                             Limits::denorm_min(),
                             Limits::infinity(),
                             Limits::quiet_NaN()};
    mesh.positions[some_vertex()][static_cast<Eigen::Index>(random_.below(3))] =
        bad[random_.below(bad.size())];
  }
  void permute() {
    std::vector<std::uint32_t> name(mesh.positions.size());
    std::iota(name.begin(), name.end(), 0U);
    random_.shuffle(name);
    IndexedMesh other = mesh;
    for (std::size_t v = 0; v < name.size(); ++v) other.positions[name[v]] = mesh.positions[v];
    for (auto& t : other.triangles) {
      for (std::uint32_t& v : t) v = name[v];
      std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(random_.below(3)), t.end());
    }
    random_.shuffle(other.triangles);
    mesh = std::move(other);
  }

  const surface::Surface& skin_;
  Random& random_;
};

inline const std::vector<Mutant::Step>& Mutant::steps() {
  static const std::vector<Step> all{{"cover twice", &Mutant::cover_twice},
                                     {"branch", &Mutant::branch},
                                     {"wind", &Mutant::wind},
                                     {"leave out", &Mutant::leave_out},
                                     {"swap parts", &Mutant::swap_parts},
                                     {"turn inside out", &Mutant::turn_inside_out},
                                     {"fill inside out", &Mutant::fill_inside_out},
                                     {"bridge", &Mutant::bridge},
                                     {"slit", &Mutant::slit_at_vertex},
                                     {"fold", &Mutant::fold},
                                     {"flip", &Mutant::flip},
                                     {"insert needle", &Mutant::insert_needle},
                                     {"scale", &Mutant::scale},
                                     {"shake", &Mutant::shake},
                                     {"round to floats", &Mutant::round_to_floats},
                                     {"round to decimals", &Mutant::round_to_decimals},
                                     {"push vertices", &Mutant::push_vertices},
                                     {"contract", &Mutant::contract},
                                     {"pinch", &Mutant::pinch},
                                     {"spoil coordinate", &Mutant::spoil_coordinate},
                                     {"permute", &Mutant::permute}};
  return all;
}

}  // namespace morskin::support
