#include "skin/atom_shares.h"

#include <Eigen/QR>
#include <algorithm>

namespace morskin::skin {

AtomShares atom_shares(const SkinSurface& skin, const SurfacePoint& x) {
  const CellAtoms atoms = skin.atoms(x.cell);
  AtomShares result;
  result.size = atoms.size();
  std::ranges::copy(atoms, result.atoms.begin());
  if (result.size == 1) {
    result.shares[0] = 1;
    return result;
  }
  const Point s = x.position - skin.jet(x.position, x.cell).half_gradient;
  const auto position = [&](std::size_t i) -> const Point& {
    return skin.points()[result.atoms[i].index()].position;
  };
  // By least squares, for s may be off the simplex's span by rounding.
  using Edges = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3>;
  const auto edges = static_cast<Eigen::Index>(result.size - 1);
  Edges from_first(3, edges);
  for (Eigen::Index i = 0; i < edges; ++i) {
    from_first.col(i) = position(static_cast<std::size_t>(i) + 1) - position(0);
  }
  const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> others =
      from_first.colPivHouseholderQr().solve(s - position(0));
  result.shares[0] = std::max(0.0, 1 - others.sum());
  double sum = result.shares[0];
  for (Eigen::Index i = 0; i < edges; ++i) {
    const double share = std::max(0.0, others[i]);
    result.shares[static_cast<std::size_t>(i) + 1] = share;
    sum += share;
  }
  for (double& share : result.shares) share /= sum;
  return result;
}

}  // namespace morskin::skin
