#include "certify/certificate.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "certify/covered_parts.h"
#include "certify/covering_degree.h"
#include "certify/delaunay_filter.h"
#include "certify/located_vertices.h"
#include "certify/residuals.h"
#include "certify/restricted_delaunay.h"
#include "certify/triangle_geometry.h"
#include "certify/tube.h"
#include "geometry/files/text_lines.h"
#include "geometry/glued_triangles.h"
#include "geometry/mesh_shape.h"
#include "geometry/parallel.h"

namespace morskin::certify {
namespace {

using geometry::IndexedMesh;
using surface::CellId;

/// Why (c1) is not proved of a triangle: a corner denies it, or it may hold all the same.
std::string not_upright(std::size_t t, const Corners& corners, const Vector& normal) {
  const bool is_denied = std::ranges::any_of(
      corners, [&](const SurfacePoint* p) { return p->normal.dot(normal) < 0; });
  return "triangle " + std::to_string(t) +
         (is_denied ? " does not face" : " is not shown to face") + " the way the skin does";
}

/// Why (c2) is not proved of a triangle: |G| < |N|^2 at each corner, or not.
std::string not_in_tube(std::size_t t, const Corners& corners, const CornerBounds& bounds) {
  bool is_off = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const double rho = corners[k]->length_scale;
    is_off = is_off || !(bounds.max_values[k] < rho * rho);
  }
  return "triangle " + std::to_string(t) +
         (is_off ? " has a corner that is too far off" : " is too big for its length scale") +
         " to be proved near the skin";
}

/// Checks one claim after the other; the first broken one is the reason.
class Certifier {
 public:
  Certifier(const IndexedMesh& mesh, Hints hints, const surface::Surface& surface,
            const Sizing& sizing, const geometry::Run& run)
      : mesh_(mesh), surface_(surface), sizing_(sizing), hints_(std::move(hints)), run_(run) {}

  Certificate prove(const surface::Topology& expected) {
    out_.vertices = mesh_.positions.size();
    out_.triangles = mesh_.triangles.size();
    out_.expected_euler_characteristic = expected.euler_characteristic;
    out_.expected_components = expected.components;
    out_.expected_genus = static_cast<long>(expected.genus);
    locate_and_glue();
    run_.report(geometry::unknown_share);
    DelaunayFilter filter(mesh_.triangles.size());
    check_triangles(filter);
    run_.report(geometry::unknown_share);
    check_fans();
    if (built_.defect) {
      out_.fail(Claim::Manifold, "not a closed oriented 2-manifold: " + *built_.defect);
      out_.fail(Claim::Degree, "not asked, for the mesh is no manifold");
      out_.volume = std::numeric_limits<double>::quiet_NaN();
    } else {
      check_covering(expected);
      out_.restricted_delaunay_violations =
          local_delaunay_violations(located(), built_.mesh, filter, run_.threads());
    }
    run_.report(geometry::unknown_share);
    check_vertices();
    out_.conclude(sizing_);
    return std::move(out_);
  }

 private:
  /// Records the first element that breaks [L] or [U], which is no reason against homeomorphy.
  static void note(Certificate& out, Claim claim, const std::string& element, double ratio) {
    out.broken[static_cast<std::size_t>(claim)] =
        element + " has " + geometry::in_digits(ratio, 3) + " times its bound";
  }
  LocatedMesh located() const { return {mesh_, vertices_, surface_}; }
  void locate_and_glue();
  void glue();
  void check_fans();      ///< the triangles at each vertex form one fan
  void check_vertices();  ///< each vertex's distance to the skin
  /// [L], [U], the conditions c1 and c2 of the theorem, angles, area and volume; components.
  void check_triangles(DelaunayFilter& filter);
  /// The results of one block of triangles.
  struct TriangleFindings {
    Certificate out;  ///< the members that check_triangle() changes
    FlowBounds flow;
    geometry::ShapeMeasure shape;
  };
  void check_triangle(std::size_t t, TriangleFindings& found, DelaunayFilter& filter) const;
  void add(TriangleFindings found);
  void check_covering(const surface::Topology& expected) {
    check_covering_degree();
    out_.compare_counts();
    check_parts(expected);
  }
  /// c3: at one vertex of every component, one sheet of mesh over the skin.
  void check_covering_degree();
  /// Where only some components are expected: whether it is these that are covered.
  void check_parts(const surface::Topology& expected) {
    const bool is_carried = out_.holds(Claim::Upright) && out_.holds(Claim::Tube);
    if (expected.inside.empty() || !is_carried) return;
    const std::string why = objection_to_parts(located(), expected);
    if (!why.empty()) out_.fail(Claim::Counts, why);
  }

  const IndexedMesh& mesh_;
  const surface::Surface& surface_;
  const Sizing sizing_;
  Hints hints_;
  const geometry::Run& run_;
  Certificate out_;
  geometry::OrDefect<geometry::GluedTriangles> built_;
  bool is_built_by_hints_ = false;
  EdgeSides sides_;
  LocatedVertices vertices_;
  std::vector<std::uint32_t> components_;  ///< by vertex
  FlowBounds flow_;
};

/// Locates the vertices and glues the triangles; neither needs the other.
void Certifier::locate_and_glue() {
  const std::size_t count = mesh_.positions.size();
  const bool has_cells = hints_.cells.size() == count;
  VertexLocator locator(mesh_, surface_);
  const auto locate = [&](std::size_t begin, std::size_t end, std::size_t) {
    if (has_cells) return locator.locate_hinted(hints_.cells, begin, end);
    locator.locate_rest(run_);  // all vertices, as one block
  };
  geometry::for_each_block_beside(
      run_.threads(), [&] { glue(); }, count, locate,
      has_cells ? geometry::usual_block : std::max<std::size_t>(count, 1));
  locator.locate_rest(run_);
  vertices_ = locator.take_vertices();
}

void Certifier::glue() {
  if (mesh_.triangles.empty()) {
    built_.defect = "no triangles";
    return;
  }
  const std::size_t count = mesh_.positions.size();
  auto glued = geometry::GluedTriangles::by_twins(count, mesh_.triangles, std::move(hints_.twins));
  is_built_by_hints_ = glued.has_value();
  if (is_built_by_hints_) {
    built_.mesh = std::move(*glued);
  } else {
    built_ = geometry::glued_triangles(count, mesh_.triangles);
  }
}

void Certifier::check_fans() {
  if (!built_.defect) built_.defect = geometry::fan_defect(built_.mesh, run_.threads());
  // Gluing is unique only if no edge occurs twice; the defect must not depend on hints.
  if (built_.defect && is_built_by_hints_) {
    built_ = geometry::closed_triangles(mesh_.positions.size(), mesh_.triangles);
  }
}

void Certifier::check_vertices() {
  out_.is_single_precision = is_single_precision(mesh_.positions);
  const Residuals found = residuals(located(), out_.is_single_precision, run_);
  out_.max_distance_to_skin = found.max_distance;
  out_.max_relative_distance_to_skin = found.max_relative_distance;
  if (!found.first_off_skin) return;
  const auto& [v, distance] = *found.first_off_skin;
  out_.fail(Claim::OnSkin, "vertex " + std::to_string(v) + " " + off_skin_in_words(distance));
}

void Certifier::check_triangles(DelaunayFilter& filter) {
  if (built_.defect) sides_ = EdgeSides(mesh_.triangles);
  out_.worst_L = std::numeric_limits<double>::infinity();
  const std::size_t count = mesh_.triangles.size();
  std::vector<TriangleFindings> found(geometry::block_count(count),
                                      {Certificate(), FlowBounds(), geometry::ShapeMeasure(mesh_)});
  const auto check = [&](std::size_t begin, std::size_t end, std::size_t block) {
    found[block].out.worst_L = out_.worst_L;
    for (std::size_t t = begin; t < end; ++t) {
      const std::size_t later = std::min(t + geometry::prefetch_ahead, end - 1);
      for (const std::uint32_t v : mesh_.triangles[later]) {
        geometry::prefetch(&vertices_[v]);
        geometry::prefetch(&mesh_.positions[v]);
      }
      check_triangle(t, found[block], filter);
    }
  };
  const auto find_components = [&] { components_ = geometry::vertex_components(mesh_); };
  geometry::for_each_block_beside(run_.threads(), find_components, count, check);
  std::size_t far = 0;
  for (const TriangleFindings& part : found) far += part.flow.far().size();
  flow_.reserve(far);
  geometry::ShapeMeasure measured(mesh_);
  for (TriangleFindings& part : found) {
    measured.add(part.shape);
    add(std::move(part));
  }
  const geometry::MeshShape shape = measured.shape();
  out_.area = shape.area;
  out_.volume = shape.volume;
  out_.min_angle_deg = shape.min_angle_deg;
  out_.max_angle_deg = shape.max_angle_deg;
}

void Certifier::add(TriangleFindings found) {
  out_.worst_U = std::max(out_.worst_U, found.out.worst_U);
  out_.worst_L = std::min(out_.worst_L, found.out.worst_L);
  out_.violations_U += found.out.violations_U;
  out_.violations_L += found.out.violations_L;
  if (found.out.min_sine < out_.min_sine) {
    out_.min_sine = found.out.min_sine;
    out_.sharpest_triangle = found.out.sharpest_triangle;
  }
  for (std::size_t claim = 0; claim < out_.broken.size(); ++claim) {
    if (out_.broken[claim].empty()) out_.broken[claim] = found.out.broken[claim];
  }
  flow_.add(std::move(found.flow));
}

void Certifier::check_triangle(std::size_t t, TriangleFindings& found,
                               DelaunayFilter& filter) const {
  Certificate& out = found.out;
  const auto& corner = mesh_.triangles[t];
  const LocatedMesh on = located();
  const LocatedMesh::CornerPoints points = on.corners(corner);
  const Corners p = points;
  const TriangleBounds shape = on.shape(corner);
  const double rho = min_length_scale(p);
  const double u = sizing_.triangle_ratio(shape.circumradius, rho);
  out.worst_U = std::max(out.worst_U, u);
  if (!(u < 1) && out.violations_U++ == 0) note(out, Claim::U, "triangle " + std::to_string(t), u);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t a = corner[k], b = corner[k == 2 ? 0 : k + 1];
    if (!sides_.is_measured(a, b)) continue;
    // Skip edges that neither are the worst nor break [L].
    const SurfacePoint &from = *p[k], &to = *p[k == 2 ? 0 : k + 1];
    if (sizing_.is_certainly_longer(from, to, std::max(out.worst_L, 1.0))) continue;
    const double l = sizing_.edge_ratio(from, to);
    out.worst_L = std::min(out.worst_L, l);
    if (!(l > 1) && out.violations_L++ == 0) {
      note(out, Claim::L, geometry::edge_in_words(std::min(a, b), std::max(a, b)), l);
    }
  }
  const CornerBounds bounds = on.corner_bounds(corner);
  filter.note(geometry::TriangleId{t}, p, shape.sides, bounds.max_value());
  const double sine = smallest_sine(shape);
  if (sine < out.min_sine) {
    out.min_sine = sine;
    out.sharpest_triangle = t;
  }
  const TubeProof proof = prove_tube(surface_, p, shape, bounds);
  if (!proof.is_upright) out.fail(Claim::Upright, not_upright(t, p, shape.normal));
  if (!proof.is_in_tube) out.fail(Claim::Tube, not_in_tube(t, p, bounds));
  found.flow.add(static_cast<std::uint32_t>(t), shape.circumradius, proof.max_path,
                 rho - bounds.max_error, bounds.max_error);
  found.shape.add(corner);
}

void Certifier::check_covering_degree() {
  out_.components = 1 + std::ranges::max(components_);
  if (!out_.holds(Claim::Upright) || !out_.holds(Claim::Tube)) {
    return out_.fail(Claim::Degree, "not asked, for the flow is not shown to carry every triangle");
  }
  const auto proved =
      CoveringDegree(located(), built_.mesh, components_, flow_).proved_vertices(run_.threads());
  for (std::size_t i = 0; i < proved.size(); ++i) {
    if (proved[i]) {
      out_.degree_vertices.push_back(*proved[i]);
    } else {
      out_.fail(Claim::Degree,
                "component " + std::to_string(i) + " could not be shown to cover the skin once");
    }
  }
  out_.covering_degree_ok = out_.degree_vertices.size() == proved.size();
}

}  // namespace

Certificate certify(const IndexedMesh& mesh, const surface::Surface& surface,
                    const surface::Topology& expected, const Sizing& sizing,
                    const geometry::Run& run) {
  return certify(mesh, Hints(), surface, expected, sizing, run);
}

Certificate certify(const IndexedMesh& mesh, Hints hints, const surface::Surface& surface,
                    const surface::Topology& expected, const Sizing& sizing,
                    const geometry::Run& run) {
  return Certifier(mesh, std::move(hints), surface, sizing, run).prove(expected);
}

}  // namespace morskin::certify
