#pragma once

/// What the exercises' tests share. They run from the project's root.

#include "papers/exercises/course.h"
#include "tests/support/meshes.h"

namespace morskin::course {

/// A test is off until its exercise has an answer.
template <class... Answers>
doctest::skip until(const Answers&... answers) {
  return doctest::skip(!(answers.has_value() && ...));
}

/// Swept from below only, as in Algorithm 1.
inline morskin::MeshingOptions one_front() { return {.sizing = {}, .fronts = 1}; }

inline morskin::MeshResult meshed(std::string_view file,
                                  const morskin::MeshingOptions& options = {},
                                  skin::Model model = skin::Model::Paper) {
  return support::meshed(support::molecule(file, model), options);
}

}  // namespace morskin::course
