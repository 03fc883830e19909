#pragma once

/// Surfaces that are no skins, as --surface names them:
///
///     sphere:R   torus:R,r   genus2
///     formula:EXPRESSION[,within=W]                 where the expression is 0; below it inside
///     gaussian:MOLECULE[,decay=D][,level=L]         Gaussians of a molecule's atoms
///
/// An expression has no comma, so what follows one are options.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "geometry/run.h"
#include "implicit/implicit_surface.h"

namespace morskin::app {

struct SurfaceInput {
  std::shared_ptr<const implicit::Function> function;
  implicit::SearchSpace space;
  std::string sha256;  ///< of the molecule's file or, without one, of the text
};

/// @throws UsageError               for words that name no surface
/// @throws geometry::UnreadableInput  for a formula, with the column, or a molecule
/// @throws geometry::RefusedInput
SurfaceInput read_surface(const std::string& text);

/// The file that such words have read; nothing where they name none.
std::optional<std::filesystem::path> molecule_of_surface(const std::string& text);

/// implicit::prepare_surface; a refusal of a level of Gaussians tells their sum.
implicit::PreparedSurface prepare_surface(const SurfaceInput& input,
                                          const std::optional<implicit::Vector>& height,
                                          const geometry::Run& run);

}  // namespace morskin::app
