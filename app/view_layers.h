#pragma once

/// The layers of a viewer page, each as arrays. Their names and meaning: `papers/viewer.md`.

#include <filesystem>
#include <string>

#include "app/figures/recorded_sweep.h"
#include "app/flow_regions.h"
#include "app/front_code.h"
#include "app/page_data.h"
#include "morse/simplification.h"
#include "skin/molecule.h"

namespace morskin::app {

/// A mesh under a name, on a grid of its own.
/// @param source  file that it is from
/// @return  how it was written; the arrays below follow its order
/// @throws geometry::RefusedInput  for coordinates that no grid can hold
FrontCode add_mesh(PageData& page, const std::string& name, const geometry::IndexedMesh& mesh,
                   const std::filesystem::path& source);

/// By vertex the mixed cell, by the number of its simplex.
void add_cells(PageData& page, const FrontCode& code, const skin::MixedComplex& complex,
               const std::vector<geometry::CellId>& cells);

/// By triangle the step of its birth, the operation that laid it and whether it lies on a seam; by
/// step what was done.
void add_sweep(PageData& page, const FrontCode& code, const figures::RecordedSweep& recorded);

/// By triangle its region.
void add_regions(PageData& page, const FrontCode& code, const FlowRegions& regions);

/// Atoms, their weights and what the file calls them, and the mixed complex by the simplices of its
/// cells.
void add_molecule(PageData& page, const skin::Molecule& molecule, const skin::SkinSurface& skin);

/// Critical points with their protecting spheres, and integral lines, of the complex as it was
/// traced and as it is after the simplification.
void add_morse(PageData& page, const morse::MorseSmaleComplex& traced,
               const morse::Simplification& simplified);

/// Limit of the steps of the slider through a sweep.
constexpr std::uint32_t max_steps = 8192;

}  // namespace morskin::app
