// Section 2.1, skin/mixed_complex.h: the mixed cell under a point.
//
// Every point x lies in the cell mu = (sigma + nu) / 2 of one simplex sigma of the regular
// triangulation: it is the middle of a point c of sigma and a point q of the power cell nu.

#include "papers/steps/step.h"
#include "skin/skin_surface.h"

int main() {
  using namespace morskin::skin;
  // Two balls that overlap, as balls of radius sqrt(weight).
  const SkinSurface skin({{{-1, 0, 0}, 2.0}, {{1, 0, 0}, 2.0}});
  bool holds = true;
  for (const Point& x : {Point(-1.2, 0.5, 0), Point(0, 0.4, 0.3), Point(0.9, 0, -0.2)}) {
    // [excerpt: step-mixed-cell]
    const CellId cell = skin.locate(x, CellId{});
    const Patch& patch = skin.complex().patch(cell);
    // N = (q - c) / 2 and x = (c + q) / 2.
    const Vector n = patch.half_gradient(x);
    const Point c = x - n, q = x + n;
    // [/excerpt]
    std::printf(
        "x = (%4.1f, %4.1f, %4.1f): cell of %zu atom%s, c = (%5.2f, %5.2f, %5.2f), "
        "q = (%5.2f, %5.2f, %5.2f)\n",
        x.x(), x.y(), x.z(), skin.atoms(cell).size(), skin.atoms(cell).size() > 1 ? "s" : "", c.x(),
        c.y(), c.z(), q.x(), q.y(), q.z());
    // c lies on the segment between the centres, q where no other atom is nearer in power.
    const auto power = [&](std::size_t i) {
      return (q - skin.points()[i].position).squaredNorm() - skin.points()[i].weight;
    };
    holds = holds && c.tail<2>().norm() < 1e-12 && std::abs(c.x()) < 1 + 1e-12;
    const double least = std::min(power(0), power(1));
    for (const AtomId atom : skin.atoms(cell)) {
      holds = holds && power(atom.index()) < least + 1e-12;
    }
  }
  return step::claim("x is the middle of a point of the simplex and a point of its power cell",
                     holds);
}
