#include "app/mesh_hashes.h"

#include <bit>
#include <vector>

#include "app/sha256.h"
#include "geometry/parallel.h"

namespace morskin::app {
namespace {

using geometry::IndexedMesh;
using geometry::Point;

static_assert(std::endian::native == std::endian::little);
static_assert(sizeof(Point) == 3 * sizeof(double));

std::array<float, 3> in_single_precision(const Point& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

template <class Values>
std::string digest(const Values& values) {
  Sha256 hash;
  hash.update(std::as_bytes(std::span(values)));
  return hash.digest();
}

}  // namespace

MeshHashes hashes_of(const IndexedMesh& mesh, Stored stored, unsigned threads) {
  if (stored == Stored::Doubles) {
    MeshHashes hashes;
    geometry::do_both(
        threads, [&] { hashes.coordinates = digest(mesh.positions); },
        [&] { hashes.faces = digest(mesh.triangles); });
    return hashes;
  }
  std::vector<std::array<float, 3>> floats;
  if (stored == Stored::Floats) {
    for (const Point& p : mesh.positions) floats.push_back(in_single_precision(p));
    return {digest(floats), digest(mesh.triangles)};
  }
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t v : triangle) {
      floats.push_back(in_single_precision(mesh.positions[v]));
    }
  }
  return {digest(floats), ""};
}

}  // namespace morskin::app
