#include <initializer_list>
#include <utility>

#include "app/check_report.h"
#include "app/report.h"
#include "app/surface_report.h"

namespace morskin::app {
namespace {

using geometry::MeshDefect;

std::string list(const std::vector<std::uint32_t>& numbers) {
  std::string text;
  for (const std::uint32_t n : numbers) text += (text.empty() ? "" : ", ") + std::to_string(n);
  return text;
}

// A verdict on a few kinds of defect: the first of them is the reason.
Verdict on_defects(const geometry::MeshCheck& topology, const std::string& name,
                   std::initializer_list<MeshDefect> kinds) {
  Verdict verdict{name, true, "", true};
  for (const MeshDefect kind : kinds) {
    const geometry::DefectCount* const defect = topology.find(kind);
    if (defect == nullptr) continue;
    verdict.holds = false;
    verdict.reason += (verdict.reason.empty() ? "" : "; ") + defect->first;
    if (defect->count > 1) {
      verdict.reason += " (the first of " + grouped(defect->count) + ")";
    }
  }
  return verdict;
}

/// Edges are those of triangles with three corners.
Verdict on_closedness(const geometry::MeshCheck& topology, std::size_t triangles) {
  Verdict verdict =
      on_defects(topology, "closed", {MeshDefect::NoTriangles, MeshDefect::BoundaryEdge});
  const geometry::DefectCount* const repeated = topology.find(MeshDefect::RepeatedCorner);
  if (repeated != nullptr && repeated->count == triangles) {
    verdict.holds = false;
    verdict.reason = "no triangle has three corners";
  }
  return verdict;
}

Verdict on_intersections(const geometry::SelfIntersections& found) {
  Verdict verdict{"without self-intersections", found.count == 0, "", true};
  if (found.count == 0) return verdict;
  verdict.reason = "triangles " + std::to_string(found.pairs[0].first) + " and " +
                   std::to_string(found.pairs[0].second) + " meet where they should not (" +
                   (found.is_complete ? "" : "at least ") +
                   counted(found.count, "such pair", "such pairs") + ")";
  return verdict;
}

Verdict on_components(const AgainstSkin& against) {
  Verdict verdict{"every component once", true, "", true};
  if (against.covered.empty()) {
    verdict.holds = verdict.is_required = false;
    verdict.reason = "cannot be told: the skin's components are too close for rounding";
  }
  for (const CoveredComponent& component : against.covered) {
    if (component.is_well()) continue;
    verdict.holds = false;
    verdict.reason += verdict.reason.empty() ? "" : "; ";
    verdict.reason += component.by.empty()
                          ? component.name + " " + component.absence
                          : component.name +
                                (component.is_dropped ? ", which is to be dropped," : "") +
                                " is covered by components " + list(component.by);
    if (verdict.reason.size() > 400) {
      verdict.reason += "; and others";
      break;
    }
  }
  return verdict;
}

Verdict on_nodes(const certify::Residuals& found) {
  Verdict verdict{"nodes in edges on the skin", !found.first_off_skin, "", true};
  if (verdict.holds) return verdict;
  const auto& [node, distance] = *found.first_off_skin;
  verdict.reason = "node " + std::to_string(node) + " " + certify::off_skin_in_words(distance);
  return verdict;
}

void add_skin_verdicts(const AgainstSkin& against, std::vector<Verdict>& verdicts) {
  const certify::Certificate& c = against.certificate;
  verdicts.push_back(on_components(against));
  using certify::Claim;
  for (const auto& [claim, name] :
       {std::pair(Claim::OnSkin, "vertices on the skin"),
        std::pair(Claim::Upright, "triangles face the way the skin does"),
        std::pair(Claim::Tube, "triangles small enough to be proved near the skin"),
        std::pair(Claim::Counts, "components, Euler characteristic and genus of the skin"),
        std::pair(Claim::Degree, "covers the skin once"), std::pair(Claim::L, "[L]"),
        std::pair(Claim::U, "[U]")}) {
    const bool needs_manifold = claim == Claim::Counts || claim == Claim::Degree;
    if (needs_manifold && !c.broken_by(Claim::Manifold).empty()) continue;
    // [L] is there for the angles, and so no condition where these are known.
    const bool is_condition =
        claim != Claim::L || !(c.proved_angle_deg() >= certify::guaranteed_angle_deg);
    verdicts.push_back({name, c.broken_by(claim).empty(), c.broken_by(claim), is_condition});
  }
  verdicts.push_back({"homeomorphic to the skin, proved", c.is_homeomorphic, c.objection(), true});
  const certify::RestrictedDelaunay& d = against.delaunay;
  Verdict delaunay{"restricted Delaunay", d.violations + d.undecided == 0, "", false};
  if (d.violations > 0) {
    delaunay.reason = "vertex " + std::to_string(d.deepest[0].vertex) +
                      " lies in the surface ball of triangle " +
                      std::to_string(d.deepest[0].triangle) + ", " + brief(d.deepest[0].depth, 2) +
                      " of its squared radius deep (the deepest of " + grouped(d.violations) + ")";
  } else if (d.undecided > 0) {
    delaunay.reason = "no surface ball of triangle " + std::to_string(d.first_undecided[0]) +
                      " was found (the first of " + grouped(d.undecided) + ")";
  }
  verdicts.push_back(delaunay);
  if (against.in_edges) verdicts.push_back(on_nodes(*against.in_edges));
}

void add_curved_verdicts(const CurvedReport& curved, std::vector<Verdict>& verdicts) {
  verdicts.push_back({"one node in each edge", curved.objection.empty(), curved.objection, true});
  Verdict regular{"curved triangles regular, proved", true, "", true};
  if (const auto unproved = curved.measures.first_unproved) {
    regular.holds = false;
    regular.reason =
        "the Jacobian of triangle " + std::to_string(*unproved) + " is not proved positive";
  }
  verdicts.push_back(regular);
}

}  // namespace

std::vector<Verdict> CheckReport::verdicts() const {
  std::vector<Verdict> result{
      on_defects(topology, "without degenerate triangles",
                 {MeshDefect::RepeatedCorner, MeshDefect::Collinear}),
      on_defects(topology, "without duplicate triangles", {MeshDefect::DuplicateTriangle}),
      on_closedness(topology, triangles),
      on_defects(topology, "manifold",
                 {MeshDefect::CrowdedEdge, MeshDefect::SplitVertex, MeshDefect::UnusedVertex}),
      on_defects(topology, "oriented", {MeshDefect::DisagreeingTriangles})};
  if (intersections) result.push_back(on_intersections(*intersections));
  if (curved) add_curved_verdicts(*curved, result);
  if (against) add_skin_verdicts(*against, result);
  for (Verdict& verdict : result) {
    if (!arguments.surface) break;
    verdict.name = about_surface(std::move(verdict.name));
    verdict.reason = about_surface(std::move(verdict.reason));
  }
  return result;
}

}  // namespace morskin::app
