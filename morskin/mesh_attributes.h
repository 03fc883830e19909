#pragma once

/// What the skin is at the vertices and triangles of its mesh, as columns of numbers for files
/// (geometry/mesh_attributes.h). All in closed form from the quadric of each vertex's mixed cell.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/indexed_mesh.h"
#include "geometry/mesh_attributes.h"
#include "geometry/run.h"
#include "skin/skin_surface.h"

namespace morskin {

/// A group of columns. By vertex, unless stated otherwise.
enum class Datum {
  Normal,      ///< nx ny nz: unit, out of the body
  Curvature,   ///< k1 k2, principal, k1 >= k2; mean_curvature gaussian_curvature shape_index
               ///< curvedness
  Directions,  ///< k1x k1y k1z k2x k2y k2z: the principal directions
  Scale,       ///< length_scale, Angstrom
  Atom,        ///< atom: the nearest by power distance, from 0
  Shares,      ///< atom1 share1 ... atom4 share4: atoms of the mixed cell, -1 where fewer
  Component,   ///< component, from 0 in the order of the vertices; is_void, 1 where it encloses a
               ///< void, 0 of a body inside one. By triangle as well
  Patch,       ///< by triangle, patch: dimension of the Delaunay simplex behind its middle
};

/// The name of a group, "curvature", and the group of a name.
std::string_view name_of(Datum datum);
std::optional<Datum> parse_datum(std::string_view name);
/// All, in the order above.
std::span<const Datum> all_data();

/// A number for each atom, to be told at vertices as well.
struct AtomProperty {
  std::string name;
  std::vector<double> of_atom;
  /// Between atoms by their shares (skin/atom_shares.h), or else the nearest atom's.
  bool is_interpolated = false;
  bool is_real = false;  ///< its values are no whole numbers; those of an interpolation never are
};

/// @param cells  by vertex, the mixed cell that it lies in
geometry::MeshAttributes mesh_attributes(const skin::SkinSurface& skin,
                                         const geometry::IndexedMesh& mesh,
                                         std::span<const geometry::CellId> cells,
                                         std::span<const Datum> data,
                                         std::span<const AtomProperty> properties = {});

/// Unit normals of the skin, out of the body, by vertex.
std::vector<geometry::Vector> skin_normals(const skin::SkinSurface& skin,
                                           const geometry::IndexedMesh& mesh,
                                           std::span<const geometry::CellId> cells);

/// What MSMS's files tell. A sphere of an atom is a contact face to them, a hyperboloid between two
/// atoms a toric one, and what three or four make a reentrant one.
geometry::MsmsColumns msms_columns(const skin::SkinSurface& skin, const geometry::IndexedMesh& mesh,
                                   std::span<const geometry::CellId> cells);

/// By atom, its part of the mesh's area, Angstrom^2: a third of each triangle goes to each corner,
/// and from there to atoms by their shares. The sum is the mesh's area.
std::vector<double> areas_of_atoms(const skin::SkinSurface& skin, const geometry::IndexedMesh& mesh,
                                   std::span<const geometry::CellId> cells);

}  // namespace morskin
