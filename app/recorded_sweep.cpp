#include "app/recorded_sweep.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "front/sweep_observer.h"

namespace morskin::app {
namespace {

using geometry::IndexedMesh;
using Corners = std::array<std::uint32_t, 3>;

constexpr std::uint32_t none = 0xFFFFFFFFU;

IndexedMesh plain(const surface::Mesh& mesh) {
  IndexedMesh result;
  result.triangles = mesh.surface.triangle_list();
  result.positions.reserve(mesh.points.size());
  for (const surface::SurfacePoint& p : mesh.points) result.positions.push_back(p.position);
  return result;
}

// By vertex before, its number after, or none. Both lists keep their order, so one walk matches
// them.
std::vector<std::uint32_t> renamed(const IndexedMesh& before, const IndexedMesh& after) {
  std::vector<std::uint32_t> number(before.positions.size(), none);
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
    if (birth[t] == none) open.push_back(t);
  }
  // By vertex the last birth about it; a triangle without one takes the earliest of its corners',
  // which is when all about it was there.
  while (!open.empty()) {
    std::vector<std::uint32_t> last(vertex_count, none);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      if (birth[t] == none) continue;
      for (const std::uint32_t v : triangles[t]) {
        last[v] = last[v] == none ? birth[t] : std::max(last[v], birth[t]);
      }
    }
    std::vector<std::uint32_t> left;
    for (const std::uint32_t t : open) {
      std::uint32_t earliest = none;
      for (const std::uint32_t v : triangles[t]) earliest = std::min(earliest, last[v]);
      birth[t] = earliest;
      if (earliest == none) left.push_back(t);
    }
    if (left.size() == open.size()) {
      for (const std::uint32_t t : left) birth[t] = 0;
      return;
    }
    open = std::move(left);
  }
}

// Takes down what the sweep does, and which triangles it has laid.
class Recorder : public morskin::Observer {
 public:
  explicit Recorder(RecordedMesh& recorded)
      : recorded_(recorded),
        operations_([&recorded](front::Operation operation, std::size_t triangles) {
          recorded.steps.push_back({operation, static_cast<std::uint32_t>(triangles)});
        }) {}

  std::vector<front::SweepObserver*> sweep_observers() override { return {&operations_}; }
  void swept(const surface::Mesh& mesh) override {
    swept_ = plain(mesh);
    const auto count = static_cast<std::uint32_t>(swept_.triangles.size());
    recorded_.laid = recorded_.steps.empty() ? count : recorded_.steps.back().triangles;
    if (mesh.surface.triangle_count() > 0) recorded_.birth = births(swept_, swept_);
  }
  void refined(const surface::Mesh& mesh) override {
    recorded_.birth = births(swept_, plain(mesh));
  }

 private:
  RecordedMesh& recorded_;
  front::OperationObserver operations_;
  IndexedMesh swept_;
};

}  // namespace

std::vector<std::uint32_t> births(const IndexedMesh& before, const IndexedMesh& after) {
  const std::vector<std::uint32_t> number = renamed(before, after);
  std::unordered_map<Corners, std::uint32_t, HashCorners> place;
  place.reserve(before.triangles.size());
  for (std::uint32_t t = 0; t < before.triangles.size(); ++t) {
    const Corners& old = before.triangles[t];
    const Corners now{number[old[0]], number[old[1]], number[old[2]]};
    if (std::ranges::find(now, none) == now.end()) place.emplace(normalised(now), t);
  }
  // Removed triangles, few, shift the places of those after them; every triangle that is as it was
  // sets that right.
  std::vector<std::uint32_t> birth(after.triangles.size(), none);
  std::uint32_t expected = 0;
  for (std::size_t t = 0; t < after.triangles.size(); ++t) {
    const auto found = place.find(normalised(after.triangles[t]));
    if (found != place.end() && found->second >= expected) expected = found->second;
    if (expected < before.triangles.size()) birth[t] = expected++;
  }
  spread_births(after.triangles, after.positions.size(), birth);
  return birth;
}

RecordedMesh mesh_and_record(const morskin::PreparedSkin& skin, morskin::MeshingOptions options,
                             const morskin::Run& run) {
  options.fronts = 1;
  options.has_safety_net = false;  // what it made would not be what the sweep laid
  RecordedMesh recorded;
  Recorder recorder(recorded);
  recorded.result = morskin::make_mesh(skin, options, recorder, run);
  return recorded;
}

}  // namespace morskin::app
