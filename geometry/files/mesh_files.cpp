#include "geometry/files/mesh_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "geometry/error.h"
#include "geometry/files/atomic_file.h"
#include "geometry/files/gzip.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/files/text_lines.h"

namespace morskin::geometry {
namespace mesh_formats {

void append_fan(IndexedMesh& mesh, std::span<const std::uint32_t> polygon) {
  for (std::size_t corner = 2; corner < polygon.size(); ++corner) {
    mesh.triangles.push_back({polygon[0], polygon[corner - 1], polygon[corner]});
  }
}

void append_corners(std::string& text, const TriangleCorners& triangle, std::uint64_t first) {
  for (const std::uint32_t corner : triangle) {
    text += ' ';
    append_number(text, corner + first);
  }
  text += '\n';
}

void append_position(std::string& text, const Point& position) {
  append_number(text, position.x());
  text += ' ';
  append_number(text, position.y());
  text += ' ';
  append_number(text, position.z());
  text += '\n';
}

double in_single_precision(double number) {
  // By way of memory: GCC 12 leaves out the rounding of two neighbours otherwise.
  const volatile auto rounded = static_cast<float>(number);
  return static_cast<double>(rounded);
}

Point take_position(std::string_view& fields, const TextLines& lines) {
  Point position;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view field = take_field(fields);
    const std::optional<double> value = parse_double(field);
    if (!value) {
      lines.fail("a vertex needs three coordinates, found " + quoted(field) +
                 "; write the mesh again");
    }
    if (!std::isfinite(*value)) {
      lines.fail("coordinate " + quoted(field) + " is not finite; remove the vertex");
    }
    position[axis] = *value;
  }
  return position;
}

}  // namespace mesh_formats

namespace {

constexpr std::size_t max_bytes = 1ULL << 34;  // of a mesh file, packed or not

/// A format by the ending of its files. One that cannot be read by itself has no parser.
struct KnownFormat {
  std::string_view ending;
  MeshFormat format;
  mesh_formats::ParsedMesh (*parse)(std::string_view bytes, const std::string& source) = nullptr;
  Provenance (*provenance)(std::string_view bytes) = nullptr;
};

/// The parser of a format whose triangles are flat.
template <IndexedMesh (*parse)(std::string_view, const std::string&)>
mesh_formats::ParsedMesh flat(std::string_view bytes, const std::string& source) {
  return {parse(bytes, source), std::nullopt};
}

constexpr std::array<KnownFormat, 10> known_formats = {{
    {".ply", MeshFormat::PlyBinary, flat<mesh_formats::parse_ply>, mesh_formats::ply_provenance},
    {".off", MeshFormat::Off, flat<mesh_formats::parse_off>, mesh_formats::off_provenance},
    {".obj", MeshFormat::Obj, flat<mesh_formats::parse_obj>, mesh_formats::obj_provenance},
    {".stl", MeshFormat::Stl, flat<mesh_formats::parse_stl>, mesh_formats::stl_provenance},
    {".vtu", MeshFormat::Vtu, mesh_formats::parse_vtu, mesh_formats::vtu_provenance},
    {".msh", MeshFormat::Msh, mesh_formats::parse_msh, mesh_formats::msh_provenance},
    {".glb", MeshFormat::Glb},
    {".npz", MeshFormat::Npz},
    {".vert", MeshFormat::MsmsVertices},
    {".face", MeshFormat::MsmsFaces},
}};

// The first line that is neither blank nor a comment.
std::string_view first_line(std::string_view bytes) {
  TextLines lines(bytes.substr(0, 4096), "");
  while (lines.advance()) {
    const std::string_view line = trimmed(lines.line());
    if (!line.empty() && line[0] != '#') return line;
  }
  return {};
}

std::optional<MeshFormat> format_by_content(std::string_view bytes) {
  if (bytes.starts_with("ply")) return MeshFormat::PlyBinary;
  if (mesh_formats::looks_like_binary_stl(bytes)) return MeshFormat::Stl;
  if (bytes.starts_with("<?xml") || bytes.starts_with("<VTKFile")) return MeshFormat::Vtu;
  if (bytes.starts_with("$MeshFormat")) return MeshFormat::Msh;
  std::string_view line = first_line(bytes);
  const std::string_view word = take_field(line);
  if (word.ends_with("OFF")) return MeshFormat::Off;
  if (lower_case(std::string(word)) == "solid") return MeshFormat::Stl;
  if (word == "v" || word == "f" || word == "o" || word == "mtllib") return MeshFormat::Obj;
  return std::nullopt;
}

}  // namespace

std::optional<MeshFormat> mesh_format_of(const std::filesystem::path& path) {
  const std::string ending = lower_case(path.extension().string());
  for (const KnownFormat& known : known_formats) {
    if (ending == known.ending) return known.format;
  }
  return std::nullopt;
}

bool is_single(MeshFormat format) { return format == MeshFormat::Stl || format == MeshFormat::Glb; }

IndexedMesh with_decimals(IndexedMesh mesh, int decimals) {
  for (Point& position : mesh.positions) {
    for (double& coordinate : position) {
      coordinate = *parse_double(mesh_formats::fixed(coordinate, decimals));
    }
  }
  return mesh;
}

IndexedMesh in_single_precision(IndexedMesh mesh) {
  for (Point& position : mesh.positions) {
    for (double& coordinate : position) coordinate = mesh_formats::in_single_precision(coordinate);
  }
  return mesh;
}

void write_mesh(const std::filesystem::path& path, const IndexedMesh& mesh, MeshFormat format) {
  write_file_atomically(path, serialized(mesh, format));
}

MeshFormat plain_format_of(const std::filesystem::path& path) {
  if (path.empty()) throw UnwritableOutput("the name of a file to write is empty; give one");
  const std::optional<MeshFormat> format = mesh_format_of(path);
  const bool is_msms = format == MeshFormat::MsmsVertices || format == MeshFormat::MsmsFaces;
  if (!format || is_msms) {
    throw UnwritableOutput(path.string() + ": cannot write: the ending stands for " +
                           (is_msms ? "two files, which hold more than a mesh" : "no mesh format") +
                           "; use .ply, .off, .obj, .stl, .vtu, .glb, .npz or .msh");
  }
  return *format;
}

void write_mesh(const std::filesystem::path& path, const IndexedMesh& mesh) {
  write_mesh(path, mesh, plain_format_of(path));
}

namespace {

// The bytes themselves, or unpacked into `buffer` if they are gzipped.
std::string_view unpacked(std::string_view bytes, const std::string& source, std::string& buffer) {
  if (!is_gzip(bytes)) return bytes;
  buffer = unpack_gzip(bytes, source, max_bytes);
  return buffer;
}

// The name without its .gz, if it has one.
std::filesystem::path unpacked_name(std::filesystem::path path) {
  if (lower_case(path.extension().string()) == ".gz") path.replace_extension();
  return path;
}

bool is_unverified(const std::filesystem::path& path) {
  return lower_case(unpacked_name(path).extension().string()) == ".unverified";
}

bool is_msms(const std::filesystem::path& path, std::string_view ending) {
  return lower_case(plain_name(path).extension().string()) == ending;
}

}  // namespace

std::vector<std::filesystem::path> msms_partners(const std::filesystem::path& path) {
  const bool is_of_vertices = is_msms(path, ".vert");
  if (!is_of_vertices && !is_msms(path, ".face")) return {};
  const std::filesystem::path name = plain_name(path);
  const bool is_upper = name.extension() == ".VERT" || name.extension() == ".FACE";
  std::array<const char*, 2> endings{".vert", ".VERT"};
  if (is_of_vertices) endings = {".face", ".FACE"};
  if (is_upper) std::swap(endings[0], endings[1]);
  std::vector<std::filesystem::path> partners;
  for (const char* const ending : endings) {
    for (const char* const packing : {"", ".gz"}) {
      std::filesystem::path partner = name.parent_path() / name.stem();
      partner += std::string(ending) + (is_unverified(path) ? ".unverified" : "") + packing;
      partners.push_back(std::move(partner));
    }
  }
  return partners;
}

namespace {

std::filesystem::path found_partner(const std::filesystem::path& path) {
  const std::vector<std::filesystem::path> partners = msms_partners(path);
  std::error_code ignored;
  const auto found = std::ranges::find_if(
      partners, [&](const auto& partner) { return std::filesystem::exists(partner, ignored); });
  if (found != partners.end()) return *found;
  throw UnreadableInput(path.string() + ": an MSMS mesh is two files; put " +
                        partners[0].filename().string() + " beside it");
}

MeshFile read_msms(const std::filesystem::path& path, std::string_view bytes) {
  const std::filesystem::path partner = found_partner(path);
  const FileBytes other = read_file(partner, max_bytes);
  std::string buffer;
  const mesh_formats::MsmsFile named{bytes, path.string()};
  const mesh_formats::MsmsFile found{unpacked(other.view(), partner.string(), buffer),
                                     partner.string()};
  const bool names_vertices = is_msms(path, ".vert");
  const mesh_formats::MsmsFile& vertices = names_vertices ? named : found;
  return {mesh_formats::parse_msms(vertices, names_vertices ? found : named), std::nullopt,
          mesh_formats::msms_provenance(vertices.bytes)};
}

// The format of a mesh that is one file and can be read. @throws UnreadableInput
const KnownFormat& readable_format(std::string_view bytes, const std::string& source) {
  if (bytes.empty()) throw UnreadableInput(source + ": is empty; name a mesh file");
  std::optional<MeshFormat> format = format_by_content(bytes);
  if (!format) format = mesh_format_of(plain_name(source));
  if (!format) {
    throw UnreadableInput(
        source +
        ": is no mesh that can be recognised; use PLY, OFF, OBJ, STL, VTU, MSH or "
        "MSMS");
  }
  if (format == MeshFormat::MsmsVertices || format == MeshFormat::MsmsFaces) {
    throw UnreadableInput(source +
                          ": is one of the two files of MSMS; name a file, so that the "
                          "other can be found beside it");
  }
  const KnownFormat& known = *std::ranges::find(known_formats, *format, &KnownFormat::format);
  if (known.parse == nullptr) {
    throw UnreadableInput(source +
                          ": GLB and NPZ files are only written; use the PLY, OFF or OBJ file");
  }
  return known;
}

}  // namespace

std::filesystem::path plain_name(const std::filesystem::path& path) {
  std::filesystem::path name = unpacked_name(path);
  if (is_unverified(path)) name.replace_extension();
  return name;
}

MeshFile read_mesh_file(const std::filesystem::path& path) {
  const FileBytes file = read_file(path, max_bytes);
  if (!is_msms(path, ".vert") && !is_msms(path, ".face")) {
    return parse_mesh_file(file.view(), path.string());
  }
  std::string buffer;
  return read_msms(path, unpacked(file.view(), path.string(), buffer));
}

IndexedMesh read_mesh(const std::filesystem::path& path) { return read_mesh_file(path).mesh; }

MeshFile parse_mesh_file(std::string_view bytes, const std::string& source) {
  std::string buffer;
  bytes = unpacked(bytes, source, buffer);
  const KnownFormat& known = readable_format(bytes, source);
  auto [mesh, curved] = known.parse(bytes, source);
  return {std::move(mesh), std::move(curved), known.provenance(bytes),
          known.format == MeshFormat::Stl};
}

IndexedMesh parse_mesh(std::string_view bytes, const std::string& source) {
  return parse_mesh_file(bytes, source).mesh;
}

IndexedMesh parse_msms(std::string_view vertices, const std::string& vertices_source,
                       std::string_view faces, const std::string& faces_source) {
  return mesh_formats::parse_msms({vertices, vertices_source}, {faces, faces_source});
}

}  // namespace morskin::geometry
