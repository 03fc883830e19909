// The steps of `check` on a mesh of about a million triangles (gramicidin A, model paper,
// C = 0.0425). Run from the project's root.

#include <benchmark/benchmark.h>

#include "bench/bundled.h"
#include "certify/deviations.h"
#include "certify/located_vertices.h"
#include "certify/mesh_quality.h"
#include "certify/restricted_delaunay.h"
#include "geometry/glued_triangles.h"
#include "geometry/mesh_check.h"
#include "geometry/mesh_shape.h"
#include "geometry/self_intersections.h"
#include "morskin/pipeline.h"

namespace {

using namespace morskin;

constexpr certify::Sizing sizing{0.0425, 1.65};

struct Million {
  PreparedSkin skin = prepare_skin(bundled_balls("1grm_model1.pdb"));
  geometry::IndexedMesh mesh = make_mesh(skin, {.sizing = sizing, .has_safety_net = false}).mesh;
  geometry::GluedTriangles glued =
      geometry::closed_triangles(mesh.positions.size(), mesh.triangles).mesh;
  std::vector<surface::SurfacePoint> points = certify::locate_vertices(mesh, skin.surface);
  certify::LocatedVertices vertices = certify::locate_with_bounds(mesh, skin.surface);
};

const Million& million() {
  static const Million made;
  return made;
}

const auto kernel = [](const char* name, auto step) {
  const auto run = [step](benchmark::State& state) {
    const Million& m = million();
    for (auto _ : state) benchmark::DoNotOptimize(step(m));
    const auto triangles = static_cast<double>(m.mesh.triangles.size());
    state.counters["triangles"] = triangles;
    state.counters["triangles/s"] =
        benchmark::Counter(triangles, benchmark::Counter::kIsIterationInvariantRate);
  };
  benchmark::RegisterBenchmark(name, run)->Unit(benchmark::kMillisecond);
};

}  // namespace

int main(int count, char** words) {
  kernel("check/shape", [](const Million& m) { return geometry::measure_shape(m.mesh); });
  kernel("check/angle_histogram",
         [](const Million& m) { return geometry::angle_histogram(m.mesh); });
  kernel("check/quality", [](const Million& m) { return certify::measure_quality(m.mesh); });
  kernel("check/topology", [](const Million& m) { return geometry::check_mesh(m.mesh); });
  kernel("check/self_intersections",
         [](const Million& m) { return geometry::self_intersections(m.mesh); });
  kernel("check/locate",
         [](const Million& m) { return certify::locate_vertices(m.mesh, m.skin.surface); });
  kernel("check/certificate", [](const Million& m) {
    return certify::certify(m.mesh, m.skin.surface, m.skin.topology, sizing);
  });
  kernel("check/deviations", [](const Million& m) {
    return certify::measure_deviations(m.mesh, m.skin.surface, m.points, sizing);
  });
  kernel("check/restricted_delaunay", [](const Million& m) {
    return certify::restricted_delaunay(m.mesh, m.skin.surface, m.points);
  });
  kernel("check/local_delaunay", [](const Million& m) {
    certify::DelaunayFilter filter(m.mesh.triangles.size());
    for (std::size_t t = 0; t < m.mesh.triangles.size(); ++t) {
      const auto [a, b, c] = m.mesh.triangles[t];
      const std::array p{&m.points[a], &m.points[b], &m.points[c]};
      filter.note(geometry::TriangleId{t}, p, certify::TriangleSides(p),
                  m.skin.surface.residual_bound(p[0]->length_scale));
    }
    return certify::local_delaunay_violations({m.mesh, m.vertices, m.skin.surface}, m.glued,
                                              filter);
  });
  benchmark::Initialize(&count, words);
  benchmark::RunSpecifiedBenchmarks();
}
