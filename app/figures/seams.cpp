#include "app/figures/seams.h"

#include <algorithm>

namespace morskin::figures {
namespace {

using front::Front;
using front::FrontEdgeId;

// Whether a touch split a polygon in two, rather than join two. From both edges on at once: it did
// if one comes round without meeting the other.
bool is_split(const Front& front, FrontEdgeId one, FrontEdgeId other) {
  FrontEdgeId a = one, b = other;
  do {
    a = front[a].next;
    b = front[b].next;
    if (a == other || b == one) return false;
  } while (a != one && b != other);
  return true;
}

}  // namespace

Seam& SeamObserver::across(FrontEdgeId e) {
  if (across_.size() <= e.index()) across_.resize(e.index() + 1, Seam::None);
  return across_[e];
}

// Of the triangle laid last.
void SeamObserver::note(const Front& front, Seam seam) {
  if (seam == Seam::None) return;
  const surface::Mesh& mesh = front.mesh();
  const std::uint32_t birth =
      (*mesh.births)[geometry::TriangleId{mesh.surface.triangle_count() - 1}];
  if (by_birth_.size() <= birth) by_birth_.resize(birth + 1, Seam::None);
  by_birth_[birth] = seam;
}

void SeamObserver::follow(const front::FrontChange& change) {
  using Kind = front::FrontChange::Kind;
  switch (change.kind) {
    case Kind::OpenedPolygon:
      for (const FrontEdgeId e : change.opened) across(e) = Seam::None;
      break;
    case Kind::NewVertex:
      note(change.front, across(change.moved[0]));
      for (const FrontEdgeId e : {change.moved[0], change.opened[0]}) across(e) = Seam::None;
      break;
    case Kind::Touch: {
      const FrontEdgeId to = change.moved[0], from = change.opened[0];
      const Seam seam = is_split(change.front, to, from) ? Seam::OneFront : Seam::TwoFronts;
      note(change.front, seam);
      for (const FrontEdgeId e : {to, from}) across(e) = seam;
      break;
    }
    case Kind::ClosedCorner: {
      const Seam left = across(change.moved[0]), gone = across(change.closed[0]);
      note(change.front, std::max(left, gone));
      const bool both = left != Seam::None && gone != Seam::None;
      across(change.moved[0]) = both ? Seam::None : std::max(left, gone);
      break;
    }
    case Kind::ClosedPolygon:
      note(change.front, std::max(across(change.closed[0]), across(change.closed[1])));
      break;
  }
}

}  // namespace morskin::figures
