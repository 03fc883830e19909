#include "app/figures/seams.h"

namespace morskin::figures {
namespace {

using front::Front;
using front::FrontEdgeId;

// Whether a touch joined two polygons, rather than split one. From both edges on at once: it split
// one if one comes round without meeting the other.
bool has_joined(const Front& front, FrontEdgeId one, FrontEdgeId other) {
  FrontEdgeId a = one, b = other;
  do {
    a = front[a].next;
    b = front[b].next;
    if (a == other || b == one) return true;
  } while (a != one && b != other);
  return false;
}

void set(std::vector<bool>& flags, std::size_t i, bool value) {
  if (flags.size() <= i) flags.resize(i + 1, false);
  flags[i] = value;
}

}  // namespace

void SeamObserver::set_across(FrontEdgeId e, bool is_across) {
  set(is_across_, e.index(), is_across);
}

void SeamObserver::note_last_triangle(const Front& front) {
  const surface::Mesh& mesh = front.mesh();
  set(by_birth_, (*mesh.births)[geometry::TriangleId{mesh.surface.triangle_count() - 1}], true);
}

void SeamObserver::follow(const front::FrontChange& change) {
  using Kind = front::FrontChange::Kind;
  switch (change.kind) {
    case Kind::OpenedPolygon:
      for (const FrontEdgeId e : change.opened) set_across(e, false);
      break;
    case Kind::NewVertex:
      if (is_across(change.moved[0])) note_last_triangle(change.front);
      for (const FrontEdgeId e : {change.moved[0], change.opened[0]}) set_across(e, false);
      break;
    case Kind::Touch: {
      const bool is_seam = has_joined(change.front, change.moved[0], change.opened[0]);
      if (is_seam || is_across(change.moved[0])) note_last_triangle(change.front);
      for (const FrontEdgeId e : {change.moved[0], change.opened[0]}) set_across(e, is_seam);
      break;
    }
    case Kind::ClosedCorner: {
      const bool before = is_across(change.moved[0]), after = is_across(change.closed[0]);
      if (before || after) note_last_triangle(change.front);
      set_across(change.moved[0], before != after);
      break;
    }
    case Kind::ClosedPolygon:
      if (is_across(change.closed[0]) || is_across(change.closed[1])) {
        note_last_triangle(change.front);
      }
      break;
  }
}

}  // namespace morskin::figures
