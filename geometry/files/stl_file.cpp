// STL: triangles without shared vertices, in single precision when binary.

#include <Eigen/Geometry>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <map>
#include <vector>

#include "geometry/error.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/files/text_lines.h"
#include "geometry/id.h"

namespace morskin::geometry::mesh_formats {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::size_t header_size = 84;  // 80 bytes of text, then the number of triangles
constexpr std::size_t record_size = 50;  // a normal, three corners, two spare bytes

// Numbers vertices by first appearance, equal ones alike: an open-addressing hash table, or a
// sorted map from where positions meet in few of its slots, as a file may choose them to.
class CornerMerger {
 public:
  explicit CornerMerger(IndexedMesh& mesh) : mesh_(mesh), slots_(1024, no_index) {}

  std::uint32_t vertex_at(const Point& position) {
    std::uint32_t& vertex = number_of(position);
    if (vertex == no_index) {
      vertex = static_cast<std::uint32_t>(mesh_.positions.size());
      mesh_.positions.push_back(position);
    }
    return vertex;
  }

 private:
  using Bits = std::array<std::uint64_t, 3>;

  // no_index for a new vertex.
  std::uint32_t& number_of(const Point& position) {
    constexpr std::size_t usual_steps = 16;  // a lookup; on average they are fewer than two
    if (steps_ > 1000 + usual_steps * ++lookups_ && sorted_.empty()) {
      for (std::uint32_t i = 0; i < mesh_.positions.size(); ++i) {
        sorted_.emplace(bits_of(mesh_.positions[i]), i);
      }
    }
    if (!sorted_.empty()) return sorted_.try_emplace(bits_of(position), no_index).first->second;
    if (2 * mesh_.positions.size() >= slots_.size()) grow();
    return slots_[slot_of(position)];
  }

  static Bits bits_of(const Point& position) {
    const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x + 0.0); };  // -0 is 0
    return {bits(position.x()), bits(position.y()), bits(position.z())};
  }

  std::size_t slot_of(const Point& position) {
    std::uint64_t hash = 0;
    const Bits bits = bits_of(position);
    for (const std::uint64_t coordinate : bits) {
      hash = (hash ^ coordinate) * 0x9E3779B97F4A7C15ULL;
      hash ^= hash >> 32;
    }
    std::size_t slot = hash & (slots_.size() - 1);
    while (slots_[slot] != no_index && bits_of(mesh_.positions[slots_[slot]]) != bits) {
      slot = (slot + 1) & (slots_.size() - 1);
      ++steps_;
    }
    return slot;
  }

  void grow() {
    slots_.assign(2 * slots_.size(), no_index);
    for (std::size_t i = 0; i < mesh_.positions.size(); ++i) {
      slots_[slot_of(mesh_.positions[i])] = static_cast<std::uint32_t>(i);
    }
  }

  IndexedMesh& mesh_;
  std::vector<std::uint32_t> slots_;
  std::size_t lookups_ = 0, steps_ = 0;  // steps from one slot to the next
  std::map<Bits, std::uint32_t> sorted_;
};

std::uint32_t count_at(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, sizeof count);
  return count;
}

IndexedMesh parse_binary_stl(std::string_view bytes, const std::string& source) {
  const std::size_t triangles = count_at(bytes);
  IndexedMesh mesh;
  CornerMerger merger(mesh);
  mesh.triangles.reserve(triangles);
  for (std::size_t i = 0; i < triangles; ++i) {
    std::array<float, 9> corners;
    std::memcpy(corners.data(), bytes.data() + header_size + i * record_size + 12, sizeof corners);
    std::array<std::uint32_t, 3> triangle;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const float* at = &corners[3 * corner];
      const Point position(at[0], at[1], at[2]);
      if (!position.allFinite()) {
        throw UnreadableInput(source + ": triangle " + std::to_string(i) +
                              " has a coordinate that is not finite; remove it");
      }
      triangle[corner] = merger.vertex_at(position);
    }
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

IndexedMesh parse_ascii_stl(std::string_view bytes, const std::string& source) {
  TextLines lines(bytes, source, LoneReturn::IsRefused);
  IndexedMesh mesh;
  CornerMerger merger(mesh);
  std::vector<std::uint32_t> corners;  // of the facet being read
  bool is_in_solid = false;
  bool is_in_facet = false;
  while (lines.advance()) {
    std::string_view fields = lines.line();
    const std::string word = lower_case(std::string(take_field(fields)));
    if (word == "solid") {
      is_in_solid = true;
    } else if (word == "facet") {
      if (is_in_facet) lines.fail("a facet begins inside another; write the mesh again");
      is_in_facet = true;
      corners.clear();
    } else if (word == "vertex") {
      if (!is_in_facet) lines.fail("a vertex stands outside a facet; write the mesh again");
      corners.push_back(merger.vertex_at(take_position(fields, lines)));
    } else if (word == "endfacet") {
      if (!is_in_facet || corners.size() != 3)
        lines.fail("a facet needs three vertices; remove it");
      append_fan(mesh, corners);
      is_in_facet = false;
    } else if (word == "endsolid") {
      is_in_solid = false;
    } else if (!word.empty() && word != "outer" && word != "endloop") {
      lines.fail(quoted(word) + " is no word of an STL file; write the mesh again");
    }
  }
  if (is_in_facet || is_in_solid) lines.fail("the file ends inside a solid; write it again");
  return mesh;
}

}  // namespace

bool looks_like_binary_stl(std::string_view bytes) {
  return bytes.size() >= header_size &&
         bytes.size() == header_size + record_size * std::size_t{count_at(bytes)};
}

IndexedMesh parse_stl(std::string_view bytes, const std::string& source) {
  if (looks_like_binary_stl(bytes)) return parse_binary_stl(bytes, source);
  const std::string beginning = lower_case(std::string(trimmed(bytes.substr(0, 256))));
  if (beginning.starts_with("solid")) return parse_ascii_stl(bytes, source);
  throw UnreadableInput(source +
                        ": is no STL file, or a truncated one: its length is not what its number "
                        "of triangles asks for; write it again");
}

std::string stl(const IndexedMesh& mesh, const Provenance& provenance) {
  const std::size_t triangles = mesh.triangles.size();
  std::string bytes = provenance.brief.empty() ? "binary STL, Angstrom" : provenance.brief;
  bytes.resize(header_size + record_size * triangles, '\0');
  const auto count = static_cast<std::uint32_t>(triangles);
  std::memcpy(bytes.data() + 80, &count, sizeof count);
  for (std::size_t i = 0; i < triangles; ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const Point& at_a = mesh.positions[a];
    const Vector across = (mesh.positions[b] - at_a).cross(mesh.positions[c] - at_a);
    std::array<float, 12> record;
    std::size_t next = 0;
    for (const Vector& vector :
         {Vector(across.stableNormalized()), at_a, mesh.positions[b], mesh.positions[c]}) {
      for (const double coordinate : vector) record[next++] = static_cast<float>(coordinate);
    }
    std::memcpy(bytes.data() + header_size + record_size * i, record.data(), sizeof record);
  }
  return bytes;
}

}  // namespace morskin::geometry::mesh_formats
