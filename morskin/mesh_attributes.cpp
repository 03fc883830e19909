#include "morskin/mesh_attributes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <utility>

#include "geometry/mesh_shape.h"
#include "skin/atom_shares.h"
#include "skin/curvatures.h"

namespace morskin {

namespace {

using geometry::Attribute;
using geometry::CellId;
using geometry::IndexedMesh;
using geometry::MeshAttributes;
using geometry::Point;
using geometry::Vector;
using surface::SurfacePoint;

constexpr std::array<std::pair<Datum, std::string_view>, 8> names = {{
    {Datum::Normal, "normal"},
    {Datum::Curvature, "curvature"},
    {Datum::Directions, "directions"},
    {Datum::Scale, "scale"},
    {Datum::Atom, "atom"},
    {Datum::Shares, "shares"},
    {Datum::Component, "component"},
    {Datum::Patch, "patch"},
}};

constexpr std::array<Datum, names.size()> every_datum = [] {
  std::array<Datum, names.size()> all{};
  for (std::size_t i = 0; i < names.size(); ++i) all[i] = names[i].first;
  return all;
}();

void append(std::vector<double>& numbers, const Vector& v) {
  numbers.insert(numbers.end(), v.data(), v.data() + 3);
}

/// Adds a group of columns whose numbers row(v) appends for the vertex v.
template <class Row>
void add_by_vertex(MeshAttributes& to, std::size_t vertices, std::string name,
                   std::vector<std::string> columns, bool is_whole, const Row& row) {
  Attribute attribute{std::move(name), std::move(columns), {}, is_whole};
  attribute.numbers.reserve(vertices * attribute.columns.size());
  for (std::size_t v = 0; v < vertices; ++v) row(v, attribute.numbers);
  to.vertices.push_back(std::move(attribute));
}

/// The vertices of a mesh as points of the skin.
class SkinVertices {
 public:
  SkinVertices(const skin::SkinSurface& skin, const IndexedMesh& mesh,
               std::span<const CellId> cells)
      : skin_(skin), mesh_(mesh), cells_(cells) {}

  std::size_t size() const { return cells_.size(); }
  SurfacePoint at(std::size_t v) const { return skin_.at(mesh_.positions[v], cells_[v]); }
  skin::Curvatures curvatures(std::size_t v) const {
    return skin_.with_patch(cells_[v],
                            [&](const skin::Patch& p) { return skin::curvatures(p, at(v)); });
  }
  geometry::AtomId nearest_atom(std::size_t v) const {
    return skin_.nearest_atom(mesh_.positions[v], cells_[v]);
  }
  skin::AtomShares shares(std::size_t v) const { return skin::atom_shares(skin_, at(v)); }
  /// Dimension of the simplex of the cell that the middle of a triangle lies in.
  int patch_dimension(const geometry::TriangleCorners& t) const {
    const Point middle =
        (mesh_.positions[t[0]] + mesh_.positions[t[1]] + mesh_.positions[t[2]]) / 3;
    return skin_.complex().dimension(skin_.locate(middle, cells_[t[0]]));
  }

 private:
  const skin::SkinSurface& skin_;
  const IndexedMesh& mesh_;
  const std::span<const CellId> cells_;
};

void add_normal(MeshAttributes& to, const SkinVertices& vertices) {
  add_by_vertex(to, vertices.size(), "normal", {"nx", "ny", "nz"}, false,
                [&](std::size_t v, auto& numbers) { append(numbers, vertices.at(v).normal); });
}

void add_curvature(MeshAttributes& to, const SkinVertices& vertices) {
  add_by_vertex(to, vertices.size(), "curvature",
                {"k1", "k2", "mean_curvature", "gaussian_curvature", "shape_index", "curvedness"},
                false, [&](std::size_t v, auto& numbers) {
                  const skin::Curvatures k = vertices.curvatures(v);
                  numbers.insert(numbers.end(), {k.principal[0], k.principal[1], k.mean(),
                                                 k.gaussian(), k.shape_index(), k.curvedness()});
                });
}

void add_directions(MeshAttributes& to, const SkinVertices& vertices) {
  add_by_vertex(to, vertices.size(), "directions", {"k1x", "k1y", "k1z", "k2x", "k2y", "k2z"},
                false, [&](std::size_t v, auto& numbers) {
                  const skin::Curvatures k = vertices.curvatures(v);
                  append(numbers, k.directions[0]);
                  append(numbers, k.directions[1]);
                });
}

void add_scale(MeshAttributes& to, const SkinVertices& vertices) {
  add_by_vertex(
      to, vertices.size(), "scale", {"length_scale"}, false,
      [&](std::size_t v, auto& numbers) { numbers.push_back(vertices.at(v).length_scale); });
}

void add_atom(MeshAttributes& to, const SkinVertices& vertices) {
  add_by_vertex(to, vertices.size(), "atom", {"atom"}, true, [&](std::size_t v, auto& numbers) {
    numbers.push_back(static_cast<double>(vertices.nearest_atom(v).value));
  });
}

void add_shares(MeshAttributes& to, const SkinVertices& vertices) {
  std::vector<skin::AtomShares> all;
  for (std::size_t v = 0; v < vertices.size(); ++v) all.push_back(vertices.shares(v));
  add_by_vertex(to, vertices.size(), "share_atoms", {"atom1", "atom2", "atom3", "atom4"}, true,
                [&](std::size_t v, auto& numbers) {
                  for (std::size_t i = 0; i < 4; ++i) {
                    const bool is_there = i < all[v].size;
                    numbers.push_back(is_there ? static_cast<double>(all[v].atoms[i].value) : -1);
                  }
                });
  add_by_vertex(to, vertices.size(), "shares", {"share1", "share2", "share3", "share4"}, false,
                [&](std::size_t v, auto& numbers) {
                  numbers.insert(numbers.end(), all[v].shares.begin(), all[v].shares.end());
                });
}

void add_property(MeshAttributes& to, const SkinVertices& vertices, const AtomProperty& property) {
  const std::vector<double>& of_atom = property.of_atom;
  const bool is_whole = !property.is_interpolated && !property.is_real;
  add_by_vertex(to, vertices.size(), property.name, {property.name}, is_whole,
                [&](std::size_t v, auto& numbers) {
                  if (!property.is_interpolated) {
                    numbers.push_back(of_atom[vertices.nearest_atom(v).index()]);
                    return;
                  }
                  const skin::AtomShares shares = vertices.shares(v);
                  double sum = 0;
                  for (std::size_t i = 0; i < shares.size; ++i) {
                    sum += shares.shares[i] * of_atom[shares.atoms[i].index()];
                  }
                  numbers.push_back(sum);
                });
}

void add_component(MeshAttributes& to, const IndexedMesh& mesh) {
  const std::vector<std::uint32_t> component = geometry::vertex_components(mesh);
  std::vector<Point> start;  // by component, its first vertex
  for (std::size_t v = 0; v < component.size(); ++v) {
    if (component[v] == start.size()) start.push_back(mesh.positions[v]);
  }
  // The wall of a void faces inwards. Seen from one of its points, so that nothing cancels.
  std::vector<double> volume(start.size(), 0);
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::uint32_t k = component[a];
    const Vector p = mesh.positions[a] - start[k], q = mesh.positions[b] - start[k];
    volume[k] += p.dot(q.cross(mesh.positions[c] - start[k]));
  }
  const auto tell = [&](std::size_t v, std::vector<double>& numbers) {
    numbers.push_back(component[v]);
    numbers.push_back(volume[component[v]] < 0 ? 1 : 0);
  };
  const std::vector<std::string> columns{"component", "is_void"};
  add_by_vertex(to, component.size(), "component", columns, true, tell);
  Attribute of_triangles{"component", columns, {}, true};
  for (const auto& t : mesh.triangles) tell(t[0], of_triangles.numbers);
  to.triangles.push_back(std::move(of_triangles));
}

void add_patch(MeshAttributes& to, const SkinVertices& vertices, const IndexedMesh& mesh) {
  Attribute patch{"patch", {"patch"}, {}, true};
  for (const auto& t : mesh.triangles) patch.numbers.push_back(vertices.patch_dimension(t));
  to.triangles.push_back(std::move(patch));
}

}  // namespace

std::string_view name_of(Datum datum) {
  return std::ranges::find(names, datum, &std::pair<Datum, std::string_view>::first)->second;
}

std::optional<Datum> parse_datum(std::string_view name) {
  for (const auto& [datum, known] : names) {
    if (name == known) return datum;
  }
  return std::nullopt;
}

std::span<const Datum> all_data() { return every_datum; }

MeshAttributes mesh_attributes(const skin::SkinSurface& skin, const IndexedMesh& mesh,
                               std::span<const CellId> cells, std::span<const Datum> data,
                               std::span<const AtomProperty> properties) {
  const SkinVertices vertices(skin, mesh, cells);
  MeshAttributes result;
  const auto add = [&](Datum datum) {
    switch (datum) {
      case Datum::Normal:
        return add_normal(result, vertices);
      case Datum::Curvature:
        return add_curvature(result, vertices);
      case Datum::Directions:
        return add_directions(result, vertices);
      case Datum::Scale:
        return add_scale(result, vertices);
      case Datum::Atom:
        return add_atom(result, vertices);
      case Datum::Shares:
        return add_shares(result, vertices);
      case Datum::Component:
        return add_component(result, mesh);
      case Datum::Patch:
        return add_patch(result, vertices, mesh);
    }
  };
  for (const Datum datum : data) add(datum);
  for (const AtomProperty& property : properties) add_property(result, vertices, property);
  return result;
}

std::vector<Vector> skin_normals(const skin::SkinSurface& skin, const IndexedMesh& mesh,
                                 std::span<const CellId> cells) {
  const SkinVertices vertices(skin, mesh, cells);
  std::vector<Vector> normals;
  for (std::size_t v = 0; v < vertices.size(); ++v) normals.push_back(vertices.at(v).normal);
  return normals;
}

geometry::MsmsColumns msms_columns(const skin::SkinSurface& skin, const IndexedMesh& mesh,
                                   std::span<const CellId> cells) {
  constexpr std::array<std::uint8_t, 4> kind_of_dimension{3, 1, 2, 2};
  const auto kind = [&](int dimension) {
    return kind_of_dimension[static_cast<std::size_t>(dimension)];
  };
  const SkinVertices vertices(skin, mesh, cells);
  geometry::MsmsColumns result;
  result.sphere_count = static_cast<std::uint32_t>(skin.points().size());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    result.spheres.push_back(vertices.nearest_atom(v).value);
    result.kinds.push_back(kind(skin.complex().dimension(cells[v])));
  }
  for (const auto& t : mesh.triangles) {
    result.face_kinds.push_back(kind(vertices.patch_dimension(t)));
  }
  return result;
}

std::vector<double> areas_of_atoms(const skin::SkinSurface& skin, const IndexedMesh& mesh,
                                   std::span<const CellId> cells) {
  std::vector<double> of_vertex(mesh.positions.size(), 0);
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vector ab = mesh.positions[b] - mesh.positions[a];
    const double area = ab.cross(mesh.positions[c] - mesh.positions[a]).norm() / 2;
    for (const std::uint32_t v : {a, b, c}) of_vertex[v] += area / 3;
  }
  const SkinVertices vertices(skin, mesh, cells);
  std::vector<double> of_atom(skin.points().size(), 0);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const skin::AtomShares shares = vertices.shares(v);
    for (std::size_t i = 0; i < shares.size; ++i) {
      of_atom[shares.atoms[i].index()] += shares.shares[i] * of_vertex[v];
    }
  }
  return of_atom;
}

}  // namespace morskin
