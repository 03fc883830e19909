// What mesh files say of their origin: written and read again in each format's place for it.

#include "geometry/files/atomic_file.h"
#include "geometry/files/mesh_formats.h"
#include "tests/support/mesh_file_cases.h"
#include "tests/support/temporary_folder.h"

using namespace morskin;
using namespace morskin::geometry;
using namespace morskin::support;

namespace {

// All that the formats need, with two entries and a brief text.
MeshAttributes told(const IndexedMesh& mesh) {
  MeshAttributes result;
  const std::size_t n = mesh.positions.size();
  result.normals.assign(n, Vector(0, 0, 1));
  result.msms.spheres.assign(n, 0);
  result.msms.kinds.assign(n, 3);
  result.msms.face_kinds.assign(mesh.triangles.size(), 3);
  result.provenance.entries = {{"input", "a%20b.pdb"}, {"C", "0.08", true}, {"chain", "A,B"}};
  result.provenance.brief = "morskin 0.1.0, certified";
  return result;
}

void check_entries(const Provenance& read, const Provenance& written) {
  REQUIRE(read.entries.size() == written.entries.size());
  for (std::size_t i = 0; i < read.entries.size(); ++i) {
    CHECK(read.entries[i].key == written.entries[i].key);
    CHECK(read.entries[i].value == written.entries[i].value);
  }
}

}  // namespace

TEST_CASE("every format that is read gives back mesh and provenance") {
  const TemporaryFolder folder;
  const IndexedMesh mesh = plain_tetrahedron();
  const MeshAttributes beside = told(mesh);
  for (const MeshFormat format : {MeshFormat::PlyBinary, MeshFormat::PlyAscii, MeshFormat::Off,
                                  MeshFormat::Obj, MeshFormat::Vtu, MeshFormat::Msh}) {
    CAPTURE(ending_of(format));
    const auto path = folder / "mesh";
    write_file_atomically(path, serialized(mesh, format, beside));
    const MeshFile read = read_mesh_file(path);
    CHECK(read.mesh == mesh);
    CHECK(!read.is_single_precision);
    check_entries(read.provenance, beside.provenance);
  }
  write_file_atomically(folder / "m.vert", serialized(mesh, MeshFormat::MsmsVertices, beside));
  write_file_atomically(folder / "m.face", serialized(mesh, MeshFormat::MsmsFaces, beside));
  for (const char* const name : {"m.vert", "m.face"}) {
    check_entries(read_mesh_file(folder / name).provenance, beside.provenance);
  }
  write_file_atomically(folder / "m.stl", serialized(mesh, MeshFormat::Stl, beside));
  const MeshFile stl = read_mesh_file(folder / "m.stl");
  CHECK(stl.provenance.brief == beside.provenance.brief);
  CHECK(stl.is_single_precision);
}

TEST_CASE("provenance changes nothing of a file but its comments") {
  const IndexedMesh mesh = plain_tetrahedron();
  MeshAttributes bare = told(mesh);
  bare.provenance = {};
  for (const MeshFormat format : read_formats) {
    if (format == MeshFormat::Stl) continue;  // has room for a line, told or not
    CAPTURE(ending_of(format));
    const std::string with = serialized(mesh, format, told(mesh));
    const std::string without = serialized(mesh, format, bare);
    CHECK(with.size() > without.size());
    CHECK(parse_mesh(with, "a") == parse_mesh(without, "a"));
  }
  CHECK(mesh_formats::off_provenance(serialized(mesh, MeshFormat::Off)).is_empty());
  CHECK(mesh_formats::stl_provenance(serialized(mesh, MeshFormat::Stl)).is_empty());
}

TEST_CASE("only comments in the format's place are provenance") {
  using namespace mesh_formats;
  const std::string line = "morskin: C 1\n";
  CHECK(ply_provenance("ply\nend_header\ncomment " + line).is_empty());
  CHECK(ply_provenance("ply\ncommentmorskin: C 1\nobj_info " + line + "end_header\n").is_empty());
  CHECK(obj_provenance("v 0 0 0\n# " + line).is_empty());
  CHECK(off_provenance("OFF\n# " + line + "0 0 0\n").is_empty());
  CHECK(off_provenance("# " + line).entries.size() == 1);
  CHECK(off_provenance("0 0 0\r\n# morskin: C 1\r\n").entries.at(0).value == "1");
  CHECK(off_provenance("").is_empty());
  CHECK(off_provenance("#").is_empty());
  CHECK(msms_provenance("1 1 0 0\n# " + line).is_empty());
  CHECK(msms_provenance("# morskin: ; C 1; D 2; ").entries.size() == 2);
  CHECK(stl_provenance("morskin 1").is_empty());
}

TEST_CASE("no more than 64 entries are read, and none that is longer than 16 KiB") {
  std::string header = "ply\ncomment morskin: long " + std::string(1 << 15, 'x') + "\n";
  for (int i = 0; i < 1000; ++i) header += "comment morskin: k v\n";
  const Provenance read = mesh_formats::ply_provenance(header);
  CHECK(read.entries.size() == 64);
  CHECK(read.entries[0].key == "k");
}

TEST_CASE("numbers that are no character stand as question marks in the provenance of a VTU file") {
  const std::string text =
      R"(<VTKFile type="UnstructuredGrid"><UnstructuredGrid><FieldData>)"
      R"(<DataArray type="UInt8" Name="input" format="ascii">97 -200 -1 128 255 98</DataArray>)"
      "</FieldData>";
  const Provenance read = mesh_formats::vtu_provenance(text);
  REQUIRE(read.entries.size() == 1);
  CHECK(read.entries[0].value == "a????b");
}

TEST_CASE("coordinates with a few decimals are those that the file of columns gives back") {
  IndexedMesh mesh = plain_tetrahedron();
  mesh.positions[0] = {-0.0004, 1.0005, -1234.56789};
  MeshAttributes beside = told(mesh);
  beside.msms.decimals = 3;
  const IndexedMesh rounded = with_decimals(mesh, 3);
  CHECK(rounded.positions[0].z() == -1234.568);
  CHECK(with_decimals(rounded, 3) == rounded);
  const std::string vertices = serialized(mesh, MeshFormat::MsmsVertices, beside);
  const std::string faces = serialized(mesh, MeshFormat::MsmsFaces, beside);
  CHECK(parse_msms(vertices, "a.vert", faces, "a.face") == rounded);
}

TEST_CASE("coordinates of single precision are those that an STL file gives back") {
  IndexedMesh mesh = plain_tetrahedron();
  for (Point& p : mesh.positions) p = p / 3 + Point(0.1, 0.2, 0.3);
  const IndexedMesh rounded = in_single_precision(mesh);
  const IndexedMesh read = parse_mesh(serialized(mesh, MeshFormat::Stl), "a.stl");
  REQUIRE(read.triangles.size() == mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& p = rounded.positions[mesh.triangles[t][k]];
      CHECK((p.array() != mesh.positions[mesh.triangles[t][k]].array()).all());
      CHECK(read.positions[read.triangles[t][k]] == p);
    }
  }
}

TEST_CASE("an empty mesh is written in the formats that are only written, too") {
  const IndexedMesh nothing;
  for (const MeshFormat format :
       {MeshFormat::Vtu, MeshFormat::Glb, MeshFormat::Npz, MeshFormat::Msh}) {
    CHECK(serialized(nothing, format, told(nothing)).size() > 100);
  }
  const std::string glb = serialized(nothing, MeshFormat::Glb);
  CHECK(glb.starts_with("glTF"));
  CHECK(glb.size() % 4 == 0);
}
