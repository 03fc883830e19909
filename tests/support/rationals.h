#pragma once

/// Vectors and linear systems in rational numbers, for oracles that do not round.

#include <gmpxx.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/point.h"

namespace morskin::support::rational {

using Vector = std::array<mpq_class, 3>;

inline mpq_class dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector minus(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vector exact(const geometry::Point& p) {
  return {mpq_class(p.x()), mpq_class(p.y()), mpq_class(p.z())};
}

/// The solution of a square system by elimination; nothing where it is singular.
inline std::optional<std::vector<mpq_class>> solve(std::vector<std::vector<mpq_class>> rows) {
  const std::size_t n = rows.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    while (pivot < n && rows[pivot][k] == 0) ++pivot;
    if (pivot == n) return std::nullopt;
    std::swap(rows[k], rows[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k || rows[i][k] == 0) continue;
      const mpq_class factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= n; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  std::vector<mpq_class> solution;
  for (std::size_t k = 0; k < n; ++k) solution.push_back(rows[k][n] / rows[k][k]);
  return solution;
}

}  // namespace morskin::support::rational
