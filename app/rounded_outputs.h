#pragma once

#include "app/arguments.h"
#include "geometry/indexed_mesh.h"

namespace morskin::app {

/// Of what is certified, files of fewer digits hold only what is near: STL and GLB in single
/// precision, MSMS's with --decimals.
/// @throws geometry::RefusedInput  where so few digits turn a triangle over or spoil its angles, or
///                                 MSMS's columns are too narrow for a number
void check_rounded_outputs(const geometry::IndexedMesh& mesh, const MeshArguments& arguments);

}  // namespace morskin::app
