#include "app/recorded_sweep.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "front/two_fronts.h"
#include "morse/make_guide.h"
#include "refine/smoothing.h"

namespace morskin::app {
namespace {

using geometry::IndexedMesh;
using geometry::no_index;
using Corners = std::array<std::uint32_t, 3>;

// By vertex before, its number after, or none. Both lists keep their order, so one walk matches
// them.
std::vector<std::uint32_t> renamed(const IndexedMesh& before, const IndexedMesh& after) {
  std::vector<std::uint32_t> number(before.positions.size(), no_index);
  std::uint32_t at = 0;
  for (std::size_t v = 0; v < before.positions.size() && at < after.positions.size(); ++v) {
    if (before.positions[v] == after.positions[at]) number[v] = at++;
  }
  return number;
}

// The smallest corner first: one name for a triangle, whichever corner it is told from.
Corners normalised(Corners t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

struct HashCorners {
  std::size_t operator()(const Corners& t) const {
    std::uint64_t h = 0;
    for (const std::uint32_t v : t) h = (h ^ v) * 0x9E3779B97F4A7C15ULL;
    return h ^ h >> 32;
  }
};

// A triangle that has no birth gets the latest of its neighbours', over and over until all have
// one.
void spread_births(const std::vector<Corners>& triangles, std::size_t vertex_count,
                   std::vector<std::uint32_t>& birth) {
  std::vector<std::uint32_t> open;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (birth[t] == no_index) open.push_back(t);
  }
  // By vertex the last birth about it; a triangle without one takes the earliest of its corners',
  // which is when all about it was there.
  while (!open.empty()) {
    std::vector<std::uint32_t> last(vertex_count, no_index);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      if (birth[t] == no_index) continue;
      for (const std::uint32_t v : triangles[t]) {
        last[v] = last[v] == no_index ? birth[t] : std::max(last[v], birth[t]);
      }
    }
    std::vector<std::uint32_t> left;
    for (const std::uint32_t t : open) {
      std::uint32_t earliest = no_index;
      for (const std::uint32_t v : triangles[t]) earliest = std::min(earliest, last[v]);
      birth[t] = earliest;
      if (earliest == no_index) left.push_back(t);
    }
    if (left.size() == open.size()) {
      for (const std::uint32_t t : left) birth[t] = 0;
      return;
    }
    open = std::move(left);
  }
}

}  // namespace

std::vector<std::uint32_t> births(const IndexedMesh& before, const IndexedMesh& after) {
  const std::vector<std::uint32_t> number = renamed(before, after);
  std::unordered_map<Corners, std::uint32_t, HashCorners> place;
  place.reserve(before.triangles.size());
  for (std::uint32_t t = 0; t < before.triangles.size(); ++t) {
    const Corners& old = before.triangles[t];
    const Corners now{number[old[0]], number[old[1]], number[old[2]]};
    if (std::ranges::find(now, no_index) == now.end()) place.emplace(normalised(now), t);
  }
  // Removed triangles, few, shift the places of those after them; every triangle that is as it was
  // sets that right.
  std::vector<std::uint32_t> birth(after.triangles.size(), no_index);
  std::uint32_t expected = 0;
  for (std::size_t t = 0; t < after.triangles.size(); ++t) {
    const auto found = place.find(normalised(after.triangles[t]));
    if (found != place.end() && found->second >= expected) expected = found->second;
    if (expected < before.triangles.size()) birth[t] = expected++;
  }
  spread_births(after.triangles, after.positions.size(), birth);
  return birth;
}

RecordedMesh mesh_and_record(const morskin::PreparedSkin& skin,
                             const morskin::MeshOptions& options) {
  RecordedMesh recorded;
  morskin::MeshResult& result = recorded.result;
  const auto progress = [&](std::string_view stage, double share) {
    if (options.progress) options.progress(stage, share);
  };
  progress("critical points", 0);
  const certify::Sizing laid = options.sizing.laid();
  const morse::Guide guide =
      morse::make_guide(skin.surface, skin.topology.skin_euler_characteristic(), options.function,
                        morskin::sphere_share(skin.surface, laid), options.threads);
  std::tie(result.minima, result.saddles, result.maxima) =
      std::tuple(guide.found[0], guide.found[1], guide.found[2]);
  result.function = guide.function;
  result.expected = skin.topology;

  front::OperationObserver recorder([&](front::Operation operation, std::size_t triangles) {
    recorded.steps.push_back({operation, static_cast<std::uint32_t>(triangles)});
  });
  front::SweepResult swept =
      front::sweep_once(skin.surface, guide, {.sizing = laid},
                        {.progress = [&](double share) { progress("sweep", share); }}, {&recorder});
  const IndexedMesh before = surface::indexed_mesh(swept.mesh);
  result.operations = swept.operations;
  result.open_edges = swept.open_edges;
  if (swept.open_edges == 0) {
    progress("refine", 0);
    if (options.sizing.is_coarser_than_laid()) {
      result.operations.coarsen =
          refine::Coarsening(skin.surface, options.sizing, swept.mesh).run();
      swept.mesh.surface.compact();
    }
    refine::Refinement refinement(skin.surface, options.sizing, swept.mesh, options.threads);
    refinement.run();
    result.refinement = refinement.counts();
  }
  recorded.birth = births(before, surface::indexed_mesh(swept.mesh));
  recorded.swept = before.triangles;
  if (swept.open_edges == 0) {
    progress("smooth", geometry::unknown_share);
    result.smoothing = refine::smooth(skin.surface, options.sizing, swept.mesh,
                                      options.angle_goal_deg, options.threads);
  }
  result.mesh = surface::indexed_mesh(
      swept.mesh);  // with the triangles of before, for smoothing moves vertices
  for (const surface::SurfacePoint& p : swept.mesh.points) result.cells.push_back(p.cell);
  progress("certify", 0);
  result.certificate =
      certify::certify(result.mesh, skin.surface, skin.topology, options.sizing, options.threads);
  return recorded;
}

}  // namespace morskin::app
