#include "app/view_layers.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/error.h"
#include "geometry/surface_mesh.h"

namespace morskin::app {
namespace {

using geometry::Point;
using Numbers = std::vector<std::uint32_t>;
using SignedNumbers = std::vector<std::int32_t>;

nlohmann::ordered_json json(const Grid& grid) {
  return {{"origin", {grid.origin.x(), grid.origin.y(), grid.origin.z()}}, {"step", grid.step}};
}

// By triangle in the order of the code, a value less the parent's.
template <class Value>
SignedNumbers against_parents(const FrontCode& code, Value value) {
  SignedNumbers result;
  result.reserve(code.triangles.size());
  Numbers values;
  values.reserve(code.triangles.size());
  for (std::size_t i = 0; i < code.triangles.size(); ++i) {
    values.push_back(value(code.triangles[i]));
    const std::uint32_t parent = i == 0 ? 0 : values[code.parents[i]];
    result.push_back(static_cast<std::int32_t>(values.back() - parent));
  }
  return result;
}

// Graphics hardware computes in single precision, squares of lengths too. Extents are 2^10 to 2^24
// steps.
bool is_shown(const Grid& grid) {
  return grid.step > 0x1p-66 && grid.step < 0x1p36 && grid.origin.allFinite();
}

// Points one after the other, each less the one before, on a grid.
void add_path(PageData& page, const std::string& name, const Grid& grid,
              const std::vector<Point>& points) {
  std::array<SignedNumbers, 3> axes;
  std::array<std::int32_t, 3> last{};
  for (const Point& p : points) {
    const auto at = grid.nearest(p);
    for (std::size_t k = 0; k < 3; ++k) axes[k].push_back(at[k] - last[k]);
    last = at;
  }
  for (std::size_t k = 0; k < 3; ++k) page.add(name + "." + "xyz"[k], axes[k]);
}

double distance_from_line(const Point& p, const Point& a, const Point& b) {
  const geometry::Vector along = b - a;
  const double length = along.squaredNorm();
  const double t = length > 0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0;
  return (p - a - t * along).norm();
}

// Appends a polyline simplified to a tolerance, without its first point (Douglas and Peucker).
void thin(std::span<const Point> line, double tolerance, std::vector<Point>& result) {
  if (line.size() < 2) return;
  double farthest = 0;
  std::size_t at = 0;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    const double d = distance_from_line(line[i], line.front(), line.back());
    if (d > farthest) {
      farthest = d;
      at = i;
    }
  }
  if (farthest > tolerance) {
    thin(line.first(at + 1), tolerance, result);
    thin(line.subspan(at), tolerance, result);
  } else {
    result.push_back(line.back());
  }
}

// Half a hundredth of an Angstrom is less than a pixel on screens; of what is tiny a thousandth is.
double line_tolerance(const std::vector<Point>& points) {
  Eigen::AlignedBox3d box;
  for (const Point& p : points) box.extend(p);
  return std::min(0.005, box.sizes().maxCoeff() / 1000);
}

void add_lines(PageData& page, const std::string& name, const morse::MorseSmaleComplex& complex,
               double tolerance) {
  std::vector<Point> points;
  Numbers lengths;
  std::vector<std::uint8_t> indices;  // of the extremum
  for (std::size_t i = 0; i < complex.arcs.size(); ++i) {
    const std::span<const Point> line = complex.line(morse::ArcId{i});
    const std::size_t before = points.size();
    points.push_back(line.front());
    thin(line, tolerance, points);
    lengths.push_back(static_cast<std::uint32_t>(points.size() - before));
    indices.push_back(
        static_cast<std::uint8_t>(complex.points[complex.arcs[i].extremum.index()].index));
  }
  const Grid grid = grid_about(points, tolerance / 10);
  page.about[name] = {{"count", lengths.size()}, {"grid", json(grid)}};
  page.add(name + ".lengths", lengths);
  page.add(name + ".index", indices);
  add_path(page, name, grid, points);
}

// By atom chain, residue, its number and the atom's name, each ended by a zero, which no label has.
void add_labels(PageData& page, const skin::Molecule& molecule) {
  std::string text;
  bool has_any = false;
  for (const skin::Atom& atom : molecule.atoms) {
    for (const skin::Label& label : {atom.chain, atom.residue, atom.residue_number, atom.name}) {
      has_any = has_any || !label.is_empty();
      text.append(label.view()).push_back('\0');
    }
  }
  if (has_any) page.add("atoms.labels", text);
}

}  // namespace

FrontCode add_mesh(PageData& page, const std::string& name, const geometry::IndexedMesh& mesh,
                   const std::filesystem::path& source) {
  const Grid grid = grid_of(mesh);
  if (!is_shown(grid)) {
    throw geometry::RefusedInput(
        source.string() +
        ": the mesh is too large or too small to be shown; give lengths in Angstrom");
  }
  if (mesh.triangles.size() > geometry::SurfaceMesh::max_triangles) {
    throw geometry::LimitReached(source.string() +
                                 ": the mesh has too many triangles for one page");
  }
  FrontCode code = front_code(mesh.triangles, mesh.positions.size());
  std::vector<std::array<std::int32_t, 3>> at;
  at.reserve(code.vertices.size());
  for (const std::uint32_t v : code.vertices) at.push_back(grid.nearest(mesh.positions[v]));
  page.about[name] = {{"triangles", code.triangles.size()},
                      {"vertices", code.vertices.size()},
                      {"grid", json(grid)}};
  page.add(name + ".cases", code.cases);
  page.add(name + ".references", code.references);
  for (std::size_t k = 0; k < 3; ++k) {
    SignedNumbers off;
    off.reserve(at.size());
    for (std::size_t v = 0; v < at.size(); ++v) {
      const auto [p, q, r] = code.predictors[v];
      const std::int32_t predicted = v == 0 ? 0 : at[p][k] + at[q][k] - at[r][k];
      off.push_back(at[v][k] - predicted);
    }
    page.add(name + "." + "xyz"[k], off);
  }
  return code;
}

void add_cells(PageData& page, const FrontCode& code, const skin::MixedComplex& complex,
               const std::vector<geometry::CellId>& cells) {
  SignedNumbers off;
  std::uint32_t last = 0;
  for (std::size_t v = 0; v < code.vertices.size(); ++v) {
    const std::uint32_t cell = complex.number(cells[code.vertices[v]]);
    off.push_back(static_cast<std::int32_t>(cell - last));
    last = cell;
  }
  page.add("mesh.cell", off);
}

void add_sweep(PageData& page, const FrontCode& code, const figures::RecordedSweep& recorded) {
  const auto count = recorded.laid;
  const std::uint32_t each = std::max(1U, (count + max_steps - 1) / max_steps);
  const std::uint32_t steps = (count + each - 1) / each;
  std::vector<std::uint8_t> operation(count, 0);  // by swept triangle
  std::array<Numbers, 5> done;                    // by operation and step
  for (Numbers& counts : done) counts.assign(steps, 0);
  for (const figures::Event& event : recorded.events) {
    const auto kind = static_cast<std::uint8_t>(event.operation);
    std::fill(operation.begin() + static_cast<std::ptrdiff_t>(event.before),
              operation.begin() + static_cast<std::ptrdiff_t>(event.after), kind);
    if (event.after > 0) ++done[kind][(event.after - 1) / each];
  }
  page.about["sweep"] = {{"steps", steps}, {"triangles_per_step", each}, {"triangles", count}};
  for (std::size_t kind = 0; kind < done.size(); ++kind) {
    page.add("sweep.done." + std::to_string(kind), done[kind]);
  }
  page.add("mesh.birth",
           against_parents(code, [&](std::uint32_t t) { return recorded.birth[t] / each; }));
  std::vector<std::uint8_t> operations, seams;
  for (const std::uint32_t t : code.triangles) {
    const std::uint32_t birth = recorded.birth[t];
    operations.push_back(operation[birth]);
    seams.push_back(birth < recorded.is_on_seam.size() && recorded.is_on_seam[birth]);
  }
  page.add("mesh.operation", operations);
  page.add("mesh.seam", seams);
}

void add_regions(PageData& page, const FrontCode& code, const FlowRegions& regions) {
  Numbers minima, maxima;
  for (const FlowRegion& region : regions.regions) {
    minima.push_back(region.minimum);
    maxima.push_back(region.maximum);
  }
  page.add("regions.minimum", minima);
  page.add("regions.maximum", maxima);
  page.add("mesh.region",
           against_parents(code, [&](std::uint32_t t) { return regions.of_triangle[t]; }));
}

void add_molecule(PageData& page, const skin::Molecule& molecule, const skin::SkinSurface& skin) {
  std::vector<double> balls;
  std::vector<float> radii;
  std::vector<std::uint8_t> element_of;
  std::map<std::string, std::uint8_t> index_of;
  nlohmann::ordered_json elements = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < molecule.atoms.size(); ++i) {
    const skin::Atom& atom = molecule.atoms[i];
    const geometry::WeightedPoint& p = skin.points()[i];
    balls.insert(balls.end(), {p.position.x(), p.position.y(), p.position.z(), p.weight});
    radii.push_back(static_cast<float>(atom.radius));
    std::string element(atom.element.view());
    // Enough for all elements; further made-up ones of a file share the last index.
    if (!index_of.contains(element) && elements.size() < 255) {
      index_of.emplace(element, static_cast<std::uint8_t>(elements.size()));
      elements.push_back(element);
    }
    const auto found = index_of.find(element);
    element_of.push_back(found == index_of.end() ? std::uint8_t{254} : found->second);
  }
  page.about["elements"] = elements;
  page.add("atoms.balls", balls);
  page.add("atoms.radius", radii);
  page.add("atoms.element", element_of);
  add_labels(page, molecule);

  const geometry::RegularTriangulation& triangulation = skin.triangulation();
  page.about["complex"] = {{"cells", skin.complex().size()}};
  // Corners ascend: the first is stored as its difference from the simplex before, the others by
  // theirs from the corner before.
  const auto add_simplices = [&](const std::string& name, const auto& simplices) {
    SignedNumbers numbers;
    std::uint32_t last = 0;
    for (const auto& simplex : simplices) {
      std::uint32_t before = std::exchange(last, simplex[0].value);
      for (const geometry::AtomId atom : simplex) {
        numbers.push_back(
            static_cast<std::int32_t>(atom.value - std::exchange(before, atom.value)));
      }
    }
    page.add("complex." + name, numbers);
  };
  std::vector<std::array<geometry::AtomId, 1>> vertices;
  for (const geometry::AtomId atom : triangulation.vertices) vertices.push_back({atom});
  add_simplices("vertices", vertices);
  add_simplices("edges", triangulation.edges);
  add_simplices("triangles", triangulation.triangles);
  add_simplices("tetrahedra", triangulation.tetrahedra);
}

void add_morse(PageData& page, const morse::MorseSmaleComplex& traced,
               const morse::Simplification& simplified) {
  std::vector<float> values;
  std::vector<std::uint8_t> indices, survives;
  Numbers heirs;  // of a cancelled extremum the one that replaced it, else the point itself
  std::array<std::size_t, 3> counts{}, left{};
  for (std::size_t i = 0; i < traced.points.size(); ++i) {
    const morse::CriticalPoint& p = traced.points[i];
    const bool stays = simplified.survives[i];
    for (const double number : {p.point.position.x(), p.point.position.y(), p.point.position.z(),
                                p.value, p.point.length_scale, simplified.radius[i]}) {
      values.push_back(static_cast<float>(number));
    }
    indices.push_back(static_cast<std::uint8_t>(p.index));
    survives.push_back(stays);
    heirs.push_back(static_cast<std::uint32_t>(i));
    ++counts[indices.back()];
    left[indices.back()] += stays;
  }
  for (const morse::Cancellation& c : simplified.cancelled) {
    heirs[c.extremum.index()] = c.heir.value;
  }
  page.about["critical"] = {{"found", counts}, {"left", left}};
  page.add("critical.points", values);
  page.add("critical.index", indices);
  page.add("critical.survives", survives);
  page.add("critical.heir", heirs);
  if (!traced.arcs.empty()) {
    const double tolerance = line_tolerance(traced.line_points);
    add_lines(page, "lines", traced, tolerance);
    add_lines(page, "kept_lines", simplified.complex, tolerance);
  }
}

}  // namespace morskin::app
