#include "front/operation_counter.h"

#include <algorithm>

namespace morskin::front {

Operations& Operations::operator+=(const Operations& other) {
  creation += other.creation;
  creep += other.creep;
  wing += other.wing;
  bridge += other.bridge;
  seal += other.seal;
  coarsen += other.coarsen;
  guard_inside_protecting += other.guard_inside_protecting;
  guard_outside_protecting += other.guard_outside_protecting;
  futile_inside_protecting += other.futile_inside_protecting;
  futile_outside_protecting += other.futile_outside_protecting;
  return *this;
}

void TouchLoops::follow(const FrontChange& change, bool is_predicted) {
  using Kind = FrontChange::Kind;
  switch (change.kind) {
    case Kind::OpenedPolygon:
      for (const FrontEdgeId e : change.opened) loop_of(e) = 0;
      break;
    case Kind::NewVertex: {
      const std::uint32_t loop = loop_of(change.moved[0]);
      loop_of(change.opened[0]) = loop;
      break;
    }
    case Kind::Touch:
      follow_touch(change.front, change.moved[0], change.opened[0], is_predicted);
      break;
    case Kind::ClosedCorner:
      break;
    case Kind::ClosedPolygon:
      loops_[loop_of(change.closed[1])].is_closed = true;
      break;
  }
}

/// @param e, added  the edges to and from the vertex touched
void TouchLoops::follow_touch(const Front& front, FrontEdgeId e, FrontEdgeId added,
                              bool is_predicted) {
  const FrontEdgeId corner = front[e].next;
  const std::uint32_t touched = loop_of(corner);
  loop_of(added) = touched;
  loops_[loop_of(e)].met_another = true;
  loops_[touched].met_another = true;
  // From both edges on at once: the polygon was split if one comes round without meeting the other.
  FrontEdgeId a = e, b = added;
  do {
    a = front[a].next;
    b = front[b].next;
    if (a == added || b == e) return;
  } while (a != e && b != added);
  const FrontEdgeId first = a == e ? e : added;
  const auto loop = static_cast<std::uint32_t>(loops_.size());
  loops_.push_back({.is_predicted = is_predicted});
  FrontEdgeId edge = first;
  do {
    loop_of(edge) = loop;
    edge = front[edge].next;
  } while (edge != first);
}

std::size_t TouchLoops::futile(bool is_predicted) const {
  return static_cast<std::size_t>(std::count_if(
      loops_.begin() + 1, loops_.end(),
      [&](const Loop& loop) { return loop.is_predicted == is_predicted && loop.is_futile(); }));
}

void TouchLoops::absorb(const TouchLoops& other, std::uint32_t offset) {
  const auto loops = static_cast<std::uint32_t>(loops_.size() - 1);
  loops_.insert(loops_.end(), other.loops_.begin() + 1, other.loops_.end());
  loop_.resize(offset, 0);
  for (const std::uint32_t loop : other.loop_) loop_.push_back(loop == 0 ? 0 : loop + loops);
}

/// A touch is predicted if either vertex lies in the sphere of a saddle or a maximum.
void OperationCounter::follow(const FrontChange& change) {
  bool is_predicted = false;
  if (change.kind == FrontChange::Kind::Touch) {
    const Front& front = change.front;
    is_predicted = is_protected(front.mesh().at(front[change.moved[0]].origin)) ||
                   is_protected(front.mesh().at(front[change.opened[0]].origin));
    ++(is_predicted ? operations_.guard_inside_protecting : operations_.guard_outside_protecting);
  }
  loops_.follow(change, is_predicted);
}

bool OperationCounter::is_protected(const SurfacePoint& x) const {
  const auto c = guide_.spheres.containing(x);
  return c && guide_.points[c->index()].index != 0;
}

void OperationCounter::operation_done(Operation operation, const Front&) {
  switch (operation) {
    case Operation::Creation:
      ++operations_.creation;
      break;
    case Operation::Creep:
      ++operations_.creep;
      break;
    case Operation::Wing:
      ++operations_.wing;
      break;
    case Operation::Bridge:
      ++operations_.bridge;
      break;
    case Operation::Seal:
      ++operations_.seal;
      break;
  }
}

void OperationCounter::marked(morse::CriticalId c, const Departure& t) {
  if (guide_.points[c.index()].index == 2) loops_.note_maximum(t.corner);
}

void OperationCounter::absorb(const OperationCounter& other, std::uint32_t edge_offset) {
  operations_ += other.operations_;
  loops_.absorb(other.loops_, edge_offset);
}

Operations OperationCounter::operations() const {
  Operations operations = operations_;
  operations.futile_inside_protecting = loops_.futile(true);
  operations.futile_outside_protecting = loops_.futile(false);
  return operations;
}

}  // namespace morskin::front
