// GLB: glTF 2.0 in one binary file, a chunk of JSON before one of numbers. Written only.
//
// glTF's numbers of vertices are single precision, and it has none of triangles. Its unit would be
// the metre; here it is the Angstrom, as asset.extras says.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <limits>
#include <nlohmann/json.hpp>

#include "geometry/error.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/files/provenance_json.h"

namespace morskin::geometry::mesh_formats {
namespace {

using nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little);

// glTF's own numbers for types and targets.
constexpr int uint32_type = 5125, float_type = 5126;
constexpr int vertex_target = 34962, index_target = 34963;
constexpr int triangles_mode = 4;

constexpr std::uint32_t json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;

void append_uint32(std::string& bytes, std::uint32_t number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// The numbers of a file, and what tells where each array of them is.
class GlbArrays {
 public:
  /// Adds an array of elements of `width` numbers each. @return the index of its accessor
  template <class Number>
  std::size_t add(const std::vector<Number>& numbers, std::size_t width, int target) {
    static_assert(sizeof(Number) == 4);  // so that all are aligned
    constexpr bool is_float = std::is_same_v<Number, float>;
    const std::size_t size = numbers.size() * sizeof(Number);
    views.push_back(
        {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", size}, {"target", target}});
    accessors.push_back({{"bufferView", views.size() - 1},
                         {"componentType", is_float ? float_type : uint32_type},
                         {"count", numbers.size() / width},
                         {"type", width == 3 ? "VEC3" : "SCALAR"}});
    bytes.append(reinterpret_cast<const char*>(numbers.data()), size);
    return accessors.size() - 1;
  }

  std::string bytes;
  ordered_json views = ordered_json::array(), accessors = ordered_json::array();
};

std::vector<float> in_single_precision(const std::vector<Vector>& vectors) {
  std::vector<float> numbers;
  numbers.reserve(3 * vectors.size());
  for (const Vector& v : vectors) {
    for (const double x : v) numbers.push_back(static_cast<float>(x));
  }
  return numbers;
}

std::size_t add_positions(GlbArrays& arrays, const IndexedMesh& mesh) {
  const std::vector<float> numbers = in_single_precision(mesh.positions);
  std::array<float, 3> least, most;
  least.fill(std::numeric_limits<float>::max());
  most.fill(std::numeric_limits<float>::lowest());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    least[i % 3] = std::min(least[i % 3], numbers[i]);
    most[i % 3] = std::max(most[i % 3], numbers[i]);
  }
  const std::size_t accessor = arrays.add(numbers, 3, vertex_target);
  arrays.accessors[accessor]["min"] = least;
  arrays.accessors[accessor]["max"] = most;
  return accessor;
}

/// Names that are not glTF's own begin with an underscore.
std::string custom_name(std::string_view column) {
  std::string name = "_";
  for (const char c : column) name += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return name;
}

void add_columns(GlbArrays& arrays, ordered_json& attributes, const Attribute& attribute) {
  const std::size_t width = attribute.columns.size();
  for (std::size_t k = 0; k < width; ++k) {
    std::vector<float> numbers;
    for (std::size_t i = k; i < attribute.numbers.size(); i += width) {
      numbers.push_back(static_cast<float>(attribute.numbers[i]));
    }
    attributes[custom_name(attribute.columns[k])] = arrays.add(numbers, 1, vertex_target);
  }
}

ordered_json primitive(GlbArrays& arrays, const IndexedMesh& mesh, const MeshAttributes& told) {
  ordered_json attributes = {{"POSITION", add_positions(arrays, mesh)}};
  if (!told.normals.empty()) {
    attributes["NORMAL"] = arrays.add(in_single_precision(told.normals), 3, vertex_target);
  }
  for (const Attribute& attribute : told.vertices) {
    if (!is_normal(attribute, told)) add_columns(arrays, attributes, attribute);
  }
  std::vector<std::uint32_t> corners;
  corners.reserve(3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  }
  return {{"attributes", attributes},
          {"indices", arrays.add(corners, 1, index_target)},
          {"mode", triangles_mode}};
}

ordered_json root_of(const Provenance& provenance) {
  ordered_json asset = {{"version", "2.0"}, {"generator", "morskin"}};
  asset["extras"] = {{"unit", "Angstrom"}, {"morskin", provenance_json(provenance)}};
  return {{"asset", asset}};
}

void add_scene(ordered_json& root, const GlbArrays& arrays, const ordered_json& primitive) {
  const auto list = [](const ordered_json& element) { return ordered_json::array({element}); };
  root["scene"] = 0;
  root["scenes"] = list({{"nodes", {0}}});
  root["nodes"] = list({{"mesh", 0}});
  root["meshes"] = list({{"primitives", list(primitive)}});
  root["accessors"] = arrays.accessors;
  root["bufferViews"] = arrays.views;
  root["buffers"] = list({{"byteLength", arrays.bytes.size()}});
}

void append_chunk(std::string& bytes, std::uint32_t kind, std::string_view content) {
  append_uint32(bytes, static_cast<std::uint32_t>(content.size()));
  append_uint32(bytes, kind);
  bytes += content;
}

}  // namespace

std::string glb(const IndexedMesh& mesh, const MeshAttributes& attributes) {
  ordered_json root = root_of(attributes.provenance);
  GlbArrays arrays;
  if (!mesh.triangles.empty()) {  // glTF has no empty arrays
    const ordered_json triangles = primitive(arrays, mesh, attributes);
    add_scene(root, arrays, triangles);
  }
  std::string json = root.dump();
  json.resize((json.size() + 3) / 4 * 4, ' ');
  constexpr std::size_t header = 12, chunk_header = 8;
  const bool has_numbers = !arrays.bytes.empty();
  const std::size_t size =
      header + (has_numbers ? 2 : 1) * chunk_header + json.size() + arrays.bytes.size();
  if (size > std::numeric_limits<std::uint32_t>::max()) {
    throw LimitReached("the mesh is too large for GLB, whose files have at most 4 GiB; use .ply");
  }
  std::string bytes = "glTF";
  bytes.reserve(size);
  append_uint32(bytes, 2);
  append_uint32(bytes, static_cast<std::uint32_t>(size));
  append_chunk(bytes, json_chunk, json);
  if (has_numbers) append_chunk(bytes, binary_chunk, arrays.bytes);
  return bytes;
}

}  // namespace morskin::geometry::mesh_formats
