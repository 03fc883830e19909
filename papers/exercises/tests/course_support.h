#pragma once

/// What the exercises' tests share. They run from the project's root.

#include "papers/exercises/course.h"
#include "papers/exercises/tests/judge.h"
#include "tests/support/meshes.h"

namespace morskin::course {

/// A test is off until its exercise has an answer.
template <class Answer>
doctest::skip until(const Answer& answer) {
  return doctest::skip(!answer.has_value());
}

/// Swept from below only, as in Algorithm 1.
inline morskin::MeshingOptions one_front(double C = 0.08) {
  return {.sizing = support::sizing_for(C), .fronts = 1};
}

/// As the command meshes it, in the model it takes unless asked.
inline morskin::MeshResult meshed(std::string_view file,
                                  const morskin::MeshingOptions& options = {},
                                  skin::Model model = skin::Model::Vdw) {
  return support::meshed(support::molecule(file, model), options);
}

}  // namespace morskin::course
