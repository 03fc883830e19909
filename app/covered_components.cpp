#include "app/covered_components.h"

#include <algorithm>
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

}  // namespace

std::vector<CoveredComponent> covered_components(const MoleculeInput& input,
                                                 const morskin::PreparedSkin& skin,
                                                 const IndexedMesh& mesh,
                                                 const geometry::MeshCheck& topology,
                                                 std::span<const surface::SurfacePoint> points) {
  const SkinComponents parts(skin.surface, skin.topology);
  auto named = named_components(input, skin);
  for (std::uint32_t c = 0; c < topology.components.size(); ++c) {
    const std::uint32_t first = mesh.triangles[topology.components[c].first_triangle][0];
    const auto sides = parts.sides(points[first]);
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
