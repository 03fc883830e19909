#include "morskin/voids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>

#include "geometry/parallel.h"
#include "skin/orthocentre.h"

namespace morskin {

namespace {

/// Cubes are made finer until this is enough, or no longer than that.
constexpr double coarsest = 0.5, finest = 1.0 / 100;
/// Bounds that are told differ by no more than this share, if `finest_told` allows it.
constexpr double narrow = 0.04, finest_told = 1.0 / 10;

/// The volume with finer and finer cubes, until it will do.
template <class WillDo>
skin::VolumeBounds volume_until(const PreparedSkin& skin, std::uint32_t cavity, double last,
                                WillDo will_do) {
  skin::VolumeBounds volume;
  for (double fineness = coarsest; fineness > last; fineness /= 2) {
    volume = skin::void_volume(skin.surface, skin.topology, cavity, fineness);
    if (will_do(volume)) break;
  }
  return volume;
}

bool is_surely_below(const PreparedSkin& skin, std::uint32_t cavity, double bound) {
  const auto is_decided = [&](const auto& v) { return v.high < bound || v.low >= bound; };
  return volume_until(skin, cavity, finest, is_decided).high < bound;
}

/// Calls visit(void) for each, on several threads.
template <class Visit>
void for_each_void(const PreparedSkin& skin, const Run& run, Visit visit) {
  run.stage("voids", [&] {
    const std::size_t count = skin.topology.voids.size();
    std::mutex reporting;
    std::size_t done = 0;
    geometry::for_each_task(run.threads(), count, [&](std::size_t cavity) {
      visit(static_cast<std::uint32_t>(cavity));
      const std::lock_guard lock(reporting);
      run.report(static_cast<double>(++done) / static_cast<double>(count));
    });
  });
}

/// One of each body: its centre lies deepest, farther from the skin than triangles are off it.
std::vector<geometry::AtomId> heaviest_atoms(const PreparedSkin& skin) {
  const auto weight = [&](geometry::AtomId a) { return skin.surface.points()[a.index()].weight; };
  const std::vector<geometry::AtomId>& vertices = skin.surface.triangulation().vertices;
  std::vector<geometry::AtomId> heaviest = skin.topology.bodies;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const std::uint32_t body = skin.topology.body_of_vertex[v];
    if (body == skin::DualComplex::no_part) continue;
    if (weight(vertices[v]) > weight(heaviest[body])) heaviest[body] = vertices[v];
  }
  return heaviest;
}

/// A point in the void, and surely in this one. @throws geometry::RefusedInput  if no double is one
geometry::Point point_in(const skin::Void& cavity, const skin::SkinSurface& surface) {
  std::array<geometry::WeightedPoint, 4> tetrahedron;
  std::ranges::transform(surface.triangulation().tetrahedra[cavity.tetrahedron],
                         tetrahedron.begin(),
                         [&](geometry::AtomId atom) { return surface.points()[atom.index()]; });
  if (const auto point = skin::point_in_free_ball(tetrahedron)) return *point;
  throw geometry::RefusedInput(
      "a void is narrower than coordinates resolve, so voids cannot be dropped: move the molecule "
      "to the origin, or keep them");
}

}  // namespace

surface::Topology PreparedSkin::expected() const {
  surface::Topology result = topology;
  if (is_dropped.empty()) return result;
  for (std::size_t i = 0; i < topology.voids.size(); ++i) {
    const skin::Void& v = topology.voids[i];
    (has_dropped(static_cast<std::uint32_t>(i)) ? result.inside : result.outside)
        .push_back(point_in(v, surface));
    if (is_dropped[i] == 0) continue;
    result.components -= v.bodies.size();
    result.euler_characteristic -= 2 * v.euler_characteristic;
  }
  for (const geometry::AtomId atom : heaviest_atoms(*this)) {
    result.inside.push_back(surface.points()[atom.index()].position);
  }
  result.genus = static_cast<std::size_t>(static_cast<long>(result.components) -
                                          result.euler_characteristic / 2);
  return result;
}

std::vector<skin::VolumeBounds> void_volumes(const PreparedSkin& skin, const Run& run) {
  std::vector<skin::VolumeBounds> volumes(skin.topology.voids.size());
  for_each_void(skin, run, [&](std::uint32_t cavity) {
    volumes[cavity] = volume_until(skin, cavity, finest_told,
                                   [](const auto& v) { return v.high - v.low <= narrow * v.high; });
  });
  return volumes;
}

void drop_voids(PreparedSkin& skin, double below, const Run& run) {
  if (!(below >= 0)) throw geometry::RefusedInput("voids have no volume below 0");
  skin.is_dropped.clear();
  if (below == 0 || skin.topology.voids.empty()) return;
  std::vector<char> is_dropped(skin.topology.voids.size(), 1);
  if (std::isfinite(below)) {
    for_each_void(skin, run, [&](std::uint32_t cavity) {
      is_dropped[cavity] = is_surely_below(skin, cavity, below) ? 1 : 0;
    });
  }
  skin.is_dropped = std::move(is_dropped);
  skin.expected();  // refuses now what it would refuse when the mesh is there
}

bool is_on_dropped(const PreparedSkin& skin, const skin::SkinComponents& parts,
                   const surface::SurfacePoint& x) {
  if (skin.is_dropped.empty()) return false;
  const auto sides = parts.sides(x);
  return sides && sides->cavity && skin.has_dropped(*sides->cavity);
}

void drop_components(const PreparedSkin& skin, surface::Mesh& mesh, const Run& run) {
  if (skin.is_dropped.empty()) return;
  const skin::SkinComponents parts(skin.surface, skin.topology);
  const geometry::Components components = geometry::components(mesh.surface);
  enum class Fate : char { Unknown, Kept, Dropped };
  std::vector<Fate> fates(components.count, Fate::Unknown);
  std::vector<geometry::TriangleId> dropped;
  for (std::size_t t = 0; t < components.of_triangle.size(); ++t) {
    const geometry::TriangleId triangle{t};
    if (mesh.surface.is_removed(triangle)) continue;
    Fate& fate = fates[components.of_triangle[t]];
    if (fate == Fate::Unknown) {
      const surface::SurfacePoint& corner = mesh.at(mesh.surface.corners(triangle)[0]);
      fate = is_on_dropped(skin, parts, corner) ? Fate::Dropped : Fate::Kept;
    }
    if (fate == Fate::Dropped) dropped.push_back(triangle);
  }
  if (dropped.empty()) return;
  mesh.surface.remove(dropped);
  mesh.surface.compact(run.threads());
}

}  // namespace morskin
