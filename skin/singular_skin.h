#pragma once

#include <string>
#include <utility>
#include <vector>

#include "geometry/error.h"
#include "geometry/id.h"

namespace morskin::skin {

/// The skin is singular: a simplex that meets its dual has weight exactly zero, so the surface has
/// a point without a tangent plane, as for two balls that touch at a point.
class SingularSkin : public geometry::RefusedInput {
 public:
  explicit SingularSkin(std::vector<geometry::AtomId> singular_atoms)
      : geometry::RefusedInput(text(singular_atoms)), atoms(std::move(singular_atoms)) {}

  std::vector<geometry::AtomId> atoms;  ///< of the simplex

 private:
  static std::string text(const std::vector<geometry::AtomId>& ids) {
    std::string list;
    for (const geometry::AtomId id : ids)
      list += (list.empty() ? "" : ", ") + std::to_string(id.value);
    return "the skin is singular at atoms " + list +
           ": the surface touches itself there; change a radius or the probe a little";
  }
};

}  // namespace morskin::skin
