#include "morskin/safety_net.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "geometry/mesh_shape.h"
#include "skin/skin_components.h"

namespace morskin {

namespace {

using geometry::IndexedMesh;
using geometry::Vector;
using surface::SurfacePoint;
using Sides = skin::SkinComponents::Sides;

/// A mesh with the mixed cells of its vertices.
struct Piece {
  IndexedMesh mesh;
  std::vector<geometry::CellId> cells;

  void append(const Piece& other) {
    mesh.append(other.mesh);
    cells.insert(cells.end(), other.cells.begin(), other.cells.end());
  }
};

/// What hangs together by triangles, each by itself.
std::vector<Piece> pieces_of(const IndexedMesh& mesh, std::span<const geometry::CellId> cells) {
  const std::vector<std::uint32_t> piece_of = geometry::vertex_components(mesh);
  std::vector<Piece> pieces;
  std::vector<std::uint32_t> index;
  for (std::size_t v = 0; v < piece_of.size(); ++v) {
    if (piece_of[v] == pieces.size()) pieces.emplace_back();
    Piece& piece = pieces[piece_of[v]];
    index.push_back(static_cast<std::uint32_t>(piece.cells.size()));
    piece.mesh.positions.push_back(mesh.positions[v]);
    piece.cells.push_back(cells[v]);
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    pieces[piece_of[a]].mesh.triangles.push_back({index[a], index[b], index[c]});
  }
  return pieces;
}

/// The expected topology of one component alone.
surface::Topology component_topology(long euler_characteristic) {
  const auto genus = static_cast<std::size_t>(1 - euler_characteristic / 2);
  return {1, genus, euler_characteristic};
}

/// The skin's components to be meshed, each with its topology, or all of them as one where rounding
/// leaves them indistinguishable.
class Parts {
 public:
  Parts(const PreparedSkin& skin, const morse::MorseFunction& function)
      : skin_(skin), components_(skin.surface, skin.topology) {
    const morse::CriticalPoints critical = morse::critical_points(skin.surface, function);
    std::map<Sides, long> characteristic;
    bool is_known = critical.degeneracies.empty();
    for (const morse::CriticalPoint& p : critical.points) {
      const std::optional<Sides> sides = components_.sides(p.point);
      is_known = is_known && sides;
      if (sides) characteristic[*sides] += p.index == 1 ? -1 : 1;
    }
    long sum = 0;
    for (const auto& [sides, chi] : characteristic) {
      sum += chi;
      is_known = is_known && chi <= 2 && chi % 2 == 0;
      if (sides.cavity && skin.has_dropped(*sides.cavity)) continue;
      topologies_.push_back(component_topology(chi));
      index_.emplace(sides, index_.size());
    }
    is_known = is_known && sum == skin.topology.skin_euler_characteristic() &&
               characteristic.size() == skin.topology.skin_components();
    if (is_known) return;
    index_.clear();
    topologies_ = {skin.expected()};
  }

  std::size_t count() const { return topologies_.size(); }
  const surface::Topology& topology(std::size_t part) const { return topologies_[part]; }

  /// The mesh cut up: all that lies on each part. A piece that lies on several is in each of them.
  std::vector<Piece> cut(const IndexedMesh& mesh, std::span<const geometry::CellId> cells) const {
    if (index_.empty()) return {Piece{mesh, {cells.begin(), cells.end()}}};
    std::vector<Piece> result(count());
    for (Piece& piece : pieces_of(mesh, cells)) {
      for (const std::size_t part : parts_under(piece)) result[part].append(piece);
      piece = {};
    }
    return result;
  }

 private:
  /// The parts that the vertices lie on.
  std::set<std::size_t> parts_under(const Piece& piece) const {
    std::set<std::size_t> parts;
    for (std::size_t v = 0; v < piece.cells.size(); ++v) {
      const auto sides =
          components_.sides(skin_.surface.at(piece.mesh.positions[v], piece.cells[v]));
      const auto part = sides ? index_.find(*sides) : index_.end();
      if (part != index_.end()) parts.insert(part->second);
    }
    return parts;
  }

  const PreparedSkin& skin_;
  skin::SkinComponents components_;
  std::map<Sides, std::size_t> index_;  ///< empty where all is one part
  std::vector<surface::Topology> topologies_;
};

/// What is left to do, part by part.
class Mending {
 public:
  Mending(const PreparedSkin& skin, const MeshingOptions& options, const Parts& parts,
          const MeshResult& result, const Run& run)
      : skin_(skin),
        options_(options),
        run_(run),
        parts_(parts),
        pieces_(parts.cut(result.mesh, result.cells)) {
    // A surface that is open somewhere is not refined anywhere.
    const bool is_refined = result.open_edges == 0;
    for (std::size_t part = 0; part < parts.count(); ++part) {
      std::string why = defect(part, pieces_[part]);
      const bool is_certified = why.empty();
      if (is_certified && is_refined) continue;
      if (is_certified) why = "certified, but not refined: the mesh was open somewhere";
      faults_.push_back({{part, std::move(why), {}}, is_certified});
    }
  }

  bool is_done() const { return mended() == faults_.size(); }
  /// The parts that were mended or would have to be.
  std::vector<Fallback> fallbacks() const {
    std::vector<Fallback> result;
    for (const Fault& fault : faults_) {
      if (fault.is_mended() || !fault.may_stay) result.push_back(fault.fallback);
    }
    return result;
  }

  /// Takes what another run made of the broken parts, where it is certified.
  void take(const surface::Mesh& mesh, const Fallback::Replacement& made_by) {
    std::vector<geometry::CellId> cells;
    for (const surface::SurfacePoint& p : mesh.points) cells.push_back(p.cell);
    std::vector<Piece> others = parts_.cut(surface::indexed_mesh(mesh), cells);
    for (Fault& fault : faults_) {
      const std::size_t part = fault.fallback.component;
      if (fault.is_mended() || !defect(part, others[part]).empty()) continue;
      fault.fallback.replacement = made_by;
      pieces_[part] = std::move(others[part]);
    }
  }

  /// All parts together, if any was replaced.
  std::optional<Piece> joined() const {
    if (mended() == 0) return std::nullopt;
    Piece whole;
    for (const Piece& piece : pieces_) whole.append(piece);
    return whole;
  }

 private:
  struct Fault {
    Fallback fallback;
    bool may_stay;  ///< certified as it is

    bool is_mended() const { return fallback.replacement.has_value(); }
  };

  std::size_t mended() const {
    return static_cast<std::size_t>(std::ranges::count_if(faults_, &Fault::is_mended));
  }
  /// Why a mesh of a part is not certified; empty if it is.
  std::string defect(std::size_t part, const Piece& piece) const {
    return run_
        .stage("certify",
               [&] {
                 return certify::certify(piece.mesh, skin_.surface, parts_.topology(part),
                                         options_.sizing, run_);
               })
        .reason;
  }

  const PreparedSkin& skin_;
  const MeshingOptions& options_;
  const Run& run_;
  const Parts& parts_;
  std::vector<Piece> pieces_;  ///< by part
  std::vector<Fault> faults_;
};

/// Heights to sweep along instead: off the axes, off the default and off each other.
std::vector<morse::MorseFunction> other_directions() {
  std::vector<morse::MorseFunction> functions;
  for (const Vector& v : {Vector(1, 0.0443, -0.0291), Vector(-0.0367, 0.0519, 1),
                          Vector(0.5711, 0.6133, 0.5453), Vector(0.5237, -0.6011, 0.6047)}) {
    functions.push_back(morse::MorseFunction::height(v));
  }
  return functions;
}

}  // namespace

bool mend(const PreparedSkin& skin, const MeshingOptions& options, bool is_method_free,
          MeshResult& result, const Run& run) {
  const bool was_swept = options.method == Method::Sweep;
  if (!options.has_safety_net || !(was_swept || is_method_free) ||
      options.guard != front::Guard::Everywhere) {
    return false;
  }
  const Parts parts(skin, result.function);
  Mending mending(skin, options, parts, result, run);
  Observer unobserved;
  MeshingOptions again = options;
  again.method = Method::Sweep;
  // For triangles this coarse another sweep closes no more often than the first, and is not much
  // quicker.
  const bool is_coarse = options.sizing.C > certify::Sizing::largest_proved_C;
  const int max_sweeps = was_swept ? (is_coarse ? 0 : 2) : 1;
  int tried = 0;
  for (const morse::MorseFunction& function :
       was_swept ? other_directions() : std::vector{result.function}) {
    if (mending.is_done() || tried == max_sweeps) break;
    again.function = function;
    try {
      const MethodResult made = run_method(skin, again, unobserved, run);
      ++tried;
      if (made.open_edges == 0) mending.take(made.mesh, {Method::Sweep, made.function});
    } catch (const morse::DegenerateFunction&) {
      continue;  // the next direction
    }
  }
  if (!mending.is_done() && was_swept) {
    again.function = result.function;
    again.method = Method::Static;
    again.mesher = {};
    mending.take(run_method(skin, again, unobserved, run).mesh, {Method::Static, result.function});
  }
  result.fallbacks = mending.fallbacks();
  std::optional<Piece> whole = mending.joined();
  if (!whole) return false;
  result.mesh = std::move(whole->mesh);
  result.cells = std::move(whole->cells);
  return true;
}

}  // namespace morskin
