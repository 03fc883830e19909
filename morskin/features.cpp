#include "morskin/features.h"

#include <utility>

#include "geometry/files/attribute_arrays.h"
#include "morskin/boundary.h"
#include "morskin/feature_data.h"
#include "morskin/pipeline.h"

namespace morskin {
namespace {

std::vector<double> coordinates(const std::vector<geometry::Point>& points) {
  std::vector<double> result;
  result.reserve(3 * points.size());
  for (const geometry::Point& p : points) result.insert(result.end(), p.data(), p.data() + 3);
  return result;
}

FeatureArray outside(geometry::NamedArray array) {
  FeatureArray result{std::move(array.name), {}, array.columns};
  std::visit([&](auto& values) { result.values = std::move(values); }, array.values);
  return result;
}

/// By vertex, what the columns of the features are.
geometry::MeshAttributes attributes_of(const PreparedSkin& skin, const MeshResult& made,
                                       const skin::Molecule& molecule) {
  std::vector<AtomProperty> properties{hydropathy_property(molecule)};
  if (!molecule.charges.empty()) properties.push_back(charge_property(molecule));
  geometry::MeshAttributes result =
      mesh_attributes(skin.surface, made.mesh, made.cells, feature_data, properties);
  result.vertices.push_back(mass_attribute(made.mesh));
  result.normals = skin_normals(skin.surface, made.mesh, made.cells);
  return result;
}

}  // namespace

Features features(const std::filesystem::path& file, const FeatureOptions& options,
                  const RunOptions& run_options) {
  return with_errors([&] {
    const skin::Molecule molecule = read_with_radii(file, options.reading);
    const Skin skin(atoms_of(molecule), options.skin, run_options);
    const PreparedSkin& prepared = skin.prepared_->skin;
    MeshResult made = make_mesh(prepared, inside(options.mesh), inside(run_options));
    const geometry::MeshAttributes attributes = attributes_of(prepared, made, molecule);

    std::vector<std::uint32_t> corners;
    for (const geometry::TriangleCorners& t : made.mesh.triangles) {
      corners.insert(corners.end(), t.begin(), t.end());
    }
    std::vector<FeatureArray> arrays{{"vertices", coordinates(made.mesh.positions), 3},
                                     {"faces", std::move(corners), 3},
                                     {"normals", coordinates(attributes.normals), 3}};
    for (auto&& some :
         {attribute_arrays(attributes), atom_arrays(molecule), laplacian_arrays(made.mesh)}) {
      for (const geometry::NamedArray& array : some) arrays.push_back(outside(array));
    }
    return Features{SkinMesh(skin, std::move(made)), std::move(arrays)};
  });
}

}  // namespace morskin
