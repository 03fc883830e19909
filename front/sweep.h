#pragma once

/// Algorithm 1 of the paper: the sweep that lays triangles from the minima of the height function
/// to its maxima, always at the lowest vertex of the front.

#include <array>
#include <functional>
#include <limits>
#include <queue>
#include <vector>

#include "certify/sizing.h"
#include "certify/triangle_geometry.h"
#include "front/front.h"
#include "front/neighbourhood.h"
#include "morse/guide.h"
#include "refine/coarsening.h"

namespace morskin::front {

/// How often each operation of section 4.1 was done.
struct Operations {
  std::size_t creation = 0;  ///< bowls at minima
  std::size_t creep = 0;     ///< fans at departure vertices
  std::size_t wing = 0;      ///< small front angles closed
  std::size_t bridge = 0;    ///< fronts joined across a saddle
  std::size_t seal = 0;      ///< holes closed at maxima
  std::size_t coarsen = 0;   ///< vertices taken out behind the front
  /// Touches of the front found by the collision guard, in and out of protecting spheres.
  std::size_t guard_inside_protecting = 0;
  std::size_t guard_outside_protecting = 0;
  /// Those of them that only split off a loop, which closed again without meeting the front or
  /// coming to a maximum.
  std::size_t vain_inside_protecting = 0;
  std::size_t vain_outside_protecting = 0;

  Operations& operator+=(const Operations& other);
};

/// One of them.
enum class Operation { Creation, Creep, Wing, Bridge, Seal };

/// Where new vertices go, in units of the tangent disk's radius r_a (section 4.2).
struct Spacing {
  double disk_share = 0.87;    ///< r_a over its upper bound; papers/4.2-curvature-adaptation.md
  double vertex_gap = 0.6;     ///< least distance of a new vertex from a front vertex
  double edge_gap = 0.4;       ///< and from a front edge
  double view = 2.2;           ///< how far the collision guard looks round a departure vertex
  double wing_angle_deg = 75;  ///< front angles below this are closed at once
  /// Where the length scale shrinks ahead of the front, as in a funnel, edges left as they are
  /// would soon be longer than it. So a corner is filled instead of closed when its triangle's
  /// circumradius exceeds `largest_ear`, and an edge longer than `longest_edge` gets a vertex of
  /// its own, at a height of `long_edge_height` over its middle.
  double largest_ear = 1;
  double longest_edge = 1.7;
  double long_edge_height = 0.7;
};

/// Where the front looks for collisions. Only `Everywhere` is safe; the others show what Morse
/// theory alone would do (papers/3.1-morse-functions.md).
enum class Guard {
  Everywhere,
  Adjacent,  ///< along the front's own polygon, and everywhere within enlarged protecting spheres
  Spheres,   ///< within enlarged protecting spheres only
};

/// A sweep on its way.
struct Snapshot {
  const morse::MorseFunction& function;
  double value;  ///< of the function at the departure vertex
  const Mesh& mesh;
  const Front& front;
};

struct SweepOptions {
  certify::Sizing sizing = {};
  /// What the mesh is to be coarsened to behind the front, whenever so many triangles are new; not
  /// at all without.
  std::optional<certify::Sizing> coarser = {};
  std::size_t coarsen_after = std::size_t{1} << 19;
  Guard guard = Guard::Everywhere;
  /// The protecting spheres enlarged, for the guards that go by them.
  std::optional<morse::ProtectingSpheres> enlarged = {};
  /// Told now and then the value at the departure vertex.
  std::function<void(double)> progress = {};
  /// What to call when the front gets to some values of the Morse function, and how many values at
  /// even steps up to the highest critical one there are to be beside the given. A value that the
  /// front never comes to shows what there is in the end. From one front only.
  std::vector<double> snapshot_values = {};
  std::size_t snapshots = 0;
  std::function<void(const Snapshot&)> snapshot = {};
  /// Called after each operation that counts, with the number of triangles there are by then.
  /// Triangles come in the order of their ids. From one front only.
  std::function<void(Operation, std::size_t triangles)> operation = {};
};

class Sweep {
 public:
  /// @param last  the sweep stays below this value of the Morse function, by a disk's radius or
  ///              more where it moves on, by next to nothing where a bowl is laid
  /// @pre the mesh is empty. Guide and mesh must outlive the sweep.
  Sweep(const surface::Surface& skin, const morse::Guide& guide, const SweepOptions& options,
        Mesh& mesh, double last = std::numeric_limits<double>::infinity());

  /// Sweeps until no bare surface is left that the front can reach.
  void run();

  /// Takes over the mesh and the front of a sweep of the reversed function that has run, and sweeps
  /// on without a last value. Nothing is left of the other's mesh.
  /// @param threads  at most, to move it
  void join(Sweep& above, unsigned threads = 1);

  Operations operations() const;
  /// Front edges left open: 0 when the mesh is closed.
  std::size_t open_edges() const { return front_.open_edges(); }

 private:
  using CriticalId = morse::CriticalId;
  struct Departure {
    double value;  ///< of the Morse function
    FrontEdgeId corner;
    std::uint32_t generation;
    bool operator>(const Departure& other) const {
      return value != other.value ? value > other.value : corner > other.corner;
    }
  };
  /// Departures stopped in the protecting sphere of a critical point.
  struct Marked {
    std::array<std::vector<Departure>, 2> sides;  ///< a saddle's two; a maximum uses the first
    bool is_done = false;
  };

  void finish();
  void coarsen();
  /// Triangles so far, those counted that coarsening has taken out again.
  std::size_t triangles_laid() const {
    return mesh_.surface.triangle_count() + 2 * operations_.coarsen;
  }
  void report(const Departure& departure);
  void note(Operation operation) const;
  void show_up_to(double value);
  void look_round(FrontEdgeId corner);
  bool is_covered_twice(const SurfacePoint& x);
  void create(const morse::CriticalPoint& minimum);
  void creep_triangles();
  bool creep(FrontEdgeId e);
  void break_long_edge(FrontEdgeId e, const SurfacePoint& centre);
  bool attach_new(FrontEdgeId e, const std::optional<SurfacePoint>& x, double r);
  void lay_fan(FrontEdgeId e, const SurfacePoint& centre, double angle, int count);
  bool is_triangle(FrontEdgeId e) const;
  std::optional<FrontEdgeId> last_apex(FrontEdgeId e) const;
  void wing();
  void close_corner(FrontEdgeId corner);
  void mark_red(CriticalId saddle, const Departure& departure);
  void bridge(CriticalId saddle);
  void seal(CriticalId maximum);
  void release_red_marks();

  bool is_current(const Departure& d) const;
  bool may_depart(const Departure& d) const;
  void push_current(std::vector<Departure>& departures);
  void push(FrontEdgeId corner);
  bool is_ear_small(FrontEdgeId corner) const;
  certify::Circumcircle ear(FrontEdgeId corner) const;
  void attach(FrontEdgeId e, FrontEdgeId corner);
  std::optional<SurfacePoint> rim_point(const SurfacePoint& centre, const Vector2& direction);
  double disk_radius(const SurfacePoint& centre, const Vector& direction) const;
  int side_of_saddle(CriticalId saddle, VertexId v) const;
  bool is_protected(VertexId v) const;

  const surface::Surface& skin_;
  const morse::Guide& guide_;
  SweepOptions options_;
  Spacing spacing_;
  double wing_cosine_;
  double disk_share_;  ///< r_a over rho
  Mesh& mesh_;
  Front front_;
  Neighbourhood near_;
  std::priority_queue<Departure, std::vector<Departure>, std::greater<>> queue_;
  std::vector<Marked> marked_;  ///< by critical point
  double last_;
  double lowest_ = 0, highest_ = 1;  ///< critical values
  std::size_t steps_ = 0, snapshots_ = 0;
  std::vector<Departure> stuck_;
  std::vector<Departure> beyond_;    ///< too near the last value
  std::vector<FrontEdgeId> fresh_;   ///< corners that the current operation made or changed
  std::vector<std::uint32_t> laid_;  ///< by mixed cell: vertices laid on its patch
  double most_on_sphere_;            ///< more vertices than fit on a whole sphere
  double largest_laid_ = 0;          ///< length scale of a vertex
  bool is_overlapping_ = false;  ///< some patch is covered more than once: the sweep has stopped
  Operations operations_;
  std::optional<refine::Coarsening> coarsening_;
  std::size_t coarsen_at_ = std::numeric_limits<std::size_t>::max();  ///< triangles
};

}  // namespace morskin::front
