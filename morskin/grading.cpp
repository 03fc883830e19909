#include "morskin/grading.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "morskin/pipeline.h"

namespace morskin {

namespace {

/// [U] keeps every point of the skin within some C Q = 0.17 length scales of a vertex of a
/// certified trial. So the vertex has at most 1 / (1 - 0.17) = 1.2 times the point's length scale,
/// and stands off by 0.2 of that: with a slope of at most 1 the point counts for no more than 1.4
/// times its own. One that even the safety net leaves uncertified costs sizes only: the mesh has
/// its own proof.
constexpr double trial_C = 0.1;

}  // namespace

std::shared_ptr<const surface::SizeField> size_field(const PreparedSkin& skin,
                                                     const MeshingOptions& options,
                                                     const geometry::Run& run) {
  const double slope = *options.grading / options.sizing.edge_share();
  if (slope >= 1) return nullptr;
  MeshingOptions trial;
  trial.sizing.C = std::min(options.sizing.C, trial_C);
  trial.sizing.Q = certify::Sizing::quality_for(trial.sizing.C);
  trial.angle_goal_deg = 0;
  trial.function = options.function;
  const MeshResult made = make_mesh(skin, trial, run);
  std::vector<surface::SizeField::Source> sources;
  for (std::size_t v = 0; v < made.cells.size(); ++v) {
    const surface::SurfacePoint p = skin.surface.at(made.mesh.positions[v], made.cells[v]);
    sources.push_back({p.position, p.length_scale});
  }
  return std::make_shared<surface::SizeField>(std::move(sources), slope);
}

Grading measure_grading(const geometry::IndexedMesh& mesh, double allowed) {
  const std::size_t n = mesh.positions.size();
  std::vector<double> lengths(n, 0);
  std::vector<std::uint32_t> counts(n, 0);
  for (const auto& corners : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = corners[k], w = corners[(k + 1) % 3];
      const double length = (mesh.positions[v] - mesh.positions[w]).norm();
      for (const std::uint32_t end : {v, w}) lengths[end] += length, ++counts[end];
    }
  }
  std::vector<surface::SizeField::Source> sizes;
  for (std::size_t v = 0; v < n; ++v) {
    if (counts[v] > 0) sizes.push_back({mesh.positions[v], lengths[v] / counts[v]});
  }
  const surface::SizeField field(sizes, allowed);
  std::vector<double> ratios;
  for (const auto& [position, size] : sizes) {
    ratios.push_back(size / field.limited(size, position));
  }
  std::ranges::sort(ratios);
  const auto quantile = [&](double share) {
    return ratios[static_cast<std::size_t>(share * static_cast<double>(ratios.size() - 1))];
  };
  return {allowed, quantile(0.5), quantile(0.99), ratios.back()};
}

}  // namespace morskin
