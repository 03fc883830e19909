#include "app/covered_components.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "app/report_lines.h"
#include "morskin/implicit_mesh.h"
#include "skin/skin_components.h"

namespace morskin::app {

using geometry::IndexedMesh;
using skin::SkinComponents;

namespace {

// The skin's components by their two sides, named.
std::map<SkinComponents::Sides, CoveredComponent> named_components(
    const MoleculeInput& input, const morskin::PreparedSkin& skin) {
  std::map<SkinComponents::Sides, CoveredComponent> named;
  const auto body_with = [&](std::uint32_t body) {
    return "the body with " + skin::describe(input.molecule, skin.topology.bodies[body]);
  };
  for (const std::uint32_t body : skin.topology.outer_bodies) {
    named[{body, std::nullopt}] = {"the outer surface of " + body_with(body), false, {}};
  }
  for (std::uint32_t cavity = 0; cavity < skin.topology.voids.size(); ++cavity) {
    const skin::Void& v = skin.topology.voids[cavity];
    const std::string at = "the void at " + brief(v.centre.x()) + " " + brief(v.centre.y()) + " " +
                           brief(v.centre.z());
    for (const std::uint32_t body : v.bodies) {
      const std::string name = v.bodies.size() == 1
                                   ? "the wall of " + at
                                   : "the surface between " + at + " and " + body_with(body);
      named[{body, cavity}] = {name, skin.has_dropped(cavity), {}};
    }
  }
  return named;
}

// By component of the mesh, the corner of its triangles that is nearest to the skin, by |G| over
// the squared length scale: a vertex off the skin may have the sides of another component.
std::vector<std::uint32_t> nearest_corners(const IndexedMesh& mesh,
                                           const geometry::MeshCheck& topology,
                                           const surface::Surface& skin,
                                           std::span<const surface::SurfacePoint> points) {
  std::vector<double> off;  // by vertex
  off.reserve(points.size());
  for (const surface::SurfacePoint& p : points) {
    const double value = skin.jet(p.position, p.cell).value;
    off.push_back(std::abs(value) / (p.length_scale * p.length_scale));
  }
  std::vector<std::uint32_t> nearest;
  for (const auto& c : topology.components) nearest.push_back(mesh.triangles[c.first_triangle][0]);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::uint32_t& best = nearest[topology.component_of_triangle[t]];
    for (const std::uint32_t v : mesh.triangles[t]) {
      if (off[v] < off[best]) best = v;
    }
  }
  return nearest;
}

}  // namespace

std::vector<CoveredComponent> covered_components(const MoleculeInput& input,
                                                 const morskin::PreparedSkin& skin,
                                                 const IndexedMesh& mesh,
                                                 const geometry::MeshCheck& topology,
                                                 std::span<const surface::SurfacePoint> points) {
  const SkinComponents parts(skin.surface, skin.topology);
  auto named = named_components(input, skin);
  const auto nearest = nearest_corners(mesh, topology, skin.surface, points);
  for (std::uint32_t c = 0; c < nearest.size(); ++c) {
    const auto sides = parts.sides(points[nearest[c]]);
    const auto found = sides ? named.find(*sides) : named.end();
    if (found == named.end()) return {};
    found->second.by.push_back(c);
  }
  std::vector<CoveredComponent> covered;
  for (auto& [sides, component] : named) covered.push_back(std::move(component));
  return covered;
}

std::vector<CoveredComponent> components_by_minima(const IndexedMesh& mesh,
                                                   const implicit::PreparedSurface& prepared) {
  std::vector<CoveredComponent> covered;
  const auto components = morskin::components_at_minima(mesh, prepared);
  std::size_t minimum = 0;
  for (const implicit::CriticalHeight& p : prepared.critical.points) {
    if (p.index != 0) continue;
    const auto& component = components[minimum++];
    const auto is_same = [&](const CoveredComponent& c) {
      return component && c.by == std::vector{*component};
    };
    if (std::ranges::any_of(covered, is_same)) continue;
    covered.push_back({"the component with the minimum at " + brief(p.position.x()) + " " +
                           brief(p.position.y()) + " " + brief(p.position.z()),
                       false,
                       {},
                       "has no vertex near enough to tell that it is covered"});
    if (component) covered.back().by.push_back(*component);
  }
  return covered;
}

}  // namespace morskin::app
