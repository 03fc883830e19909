#include "geometry/files/mesh_files.h"

#include <cstring>

#include "geometry/error.h"
#include "tests/support/mesh_file_cases.h"
#include "tests/support/temporary_folder.h"

using namespace morskin;
using namespace morskin::geometry;
using namespace morskin::support;

namespace {

// To the last bit, so that -0 is not 0.
bool is_identical(const IndexedMesh& a, const IndexedMesh& b) {
  return a.triangles == b.triangles && a.positions.size() == b.positions.size() &&
         std::ranges::equal(a.positions, b.positions, [](const Point& p, const Point& q) {
           return std::memcmp(p.data(), q.data(), 3 * sizeof(double)) == 0;
         });
}

constexpr MeshFormat exact_formats[] = {MeshFormat::PlyBinary, MeshFormat::PlyAscii,
                                        MeshFormat::Off, MeshFormat::Obj};

}  // namespace

TEST_CASE("PLY, OFF and OBJ give every coordinate back to the last bit") {
  const TemporaryFolder folder;
  for (const MeshFormat format : exact_formats) {
    CAPTURE(ending_of(format));
    const auto path = folder / ending_of(format);
    write_mesh(path, awkward_tetrahedron(), format);
    CHECK(is_identical(read_mesh(path), awkward_tetrahedron()));
  }
}

TEST_CASE("a mesh without triangles, or without anything, survives every exact format") {
  for (const MeshFormat format : exact_formats) {
    CAPTURE(ending_of(format));
    const IndexedMesh points{{{1, 2, 3}}, {}};
    CHECK(is_identical(parse_mesh(serialized(points, format), ending_of(format)), points));
    CHECK(is_identical(parse_mesh(serialized({}, format), ending_of(format)), {}));
  }
}

TEST_CASE("STL gives single precision back and joins equal corners") {
  const IndexedMesh mesh = parse_mesh(serialized(plain_tetrahedron(), MeshFormat::Stl), "mesh.stl");
  CHECK(mesh.positions.size() == 4);
  CHECK(mesh.triangles.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      CHECK(mesh.positions[mesh.triangles[i][corner]] ==
            plain_tetrahedron().positions[plain_tetrahedron().triangles[i][corner]]);
    }
  }
}

TEST_CASE("corners of an STL file are equal whatever the sign of their zeros") {
  IndexedMesh mesh = plain_tetrahedron();
  mesh.positions[0] = Point(0, 0, 0);
  std::string text = serialized(mesh, MeshFormat::Stl);
  constexpr std::size_t header = 84, triangle = 50, normal = 12, number = 4;
  int negated = 0;
  for (std::size_t at = header + normal; at < text.size(); at += 2 * triangle) {
    for (std::size_t k = 0; k < 9; ++k) {
      const std::size_t last = at + (k + 1) * number - 1;
      if (text.substr(at + k * number, number) != std::string(number, '\0')) continue;
      text[last] = '\x80';  // -0
      ++negated;
    }
  }
  CHECK(negated > 0);
  CHECK(parse_mesh(text, "mesh.stl").positions.size() == 4);
}

TEST_CASE("a large STL mesh comes back with as many vertices as it had") {
  IndexedMesh strip;
  for (std::uint32_t i = 0; i < 5000; ++i) strip.positions.push_back(Point(i, i % 2, 0));
  for (std::uint32_t i = 0; i + 2 < 5000; ++i) strip.triangles.push_back({i, i + 1, i + 2});
  CHECK(is_identical(parse_mesh(serialized(strip, MeshFormat::Stl), "strip.stl"), strip));
}

TEST_CASE("an STL file as text is read") {
  const IndexedMesh mesh = parse_mesh(
      "solid a\nfacet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n"
      " endloop\nendfacet\nfacet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 1 0\n"
      "vertex 0 1 0\nendloop\nendfacet\nendsolid a\n",
      "mesh.stl");
  CHECK(mesh.positions.size() == 4);
  CHECK(mesh.triangles[1] == std::array<std::uint32_t, 3>{1, 3, 2});
}

TEST_CASE("an STL file as text may be in capitals, whatever its name") {
  const std::string text =
      "SOLID A\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 0 1 0\n"
      "ENDLOOP\nENDFACET\nENDSOLID A\n";
  for (const char* const name : {"mesh.stl", "mesh"}) {
    CHECK(parse_mesh(text, name).triangles.size() == 1);
  }
}

TEST_CASE("the VTU text names its arrays and their sizes") {
  const std::string text = serialized(plain_tetrahedron(), MeshFormat::Vtu);
  CHECK(contains(text, "NumberOfPoints=\"4\" NumberOfCells=\"4\""));
  CHECK(contains(text, "header_type=\"UInt64\""));
  // The types: a count of 4, then four times VTK_TRIANGLE = 5.
  CHECK(contains(text, ">BAAAAAAAAAAFBQUF</DataArray>"));
}

TEST_CASE("a PLY file in the other byte order, in single precision, with more in it, is read") {
  std::string bytes =
      "ply\r\nformat binary_big_endian 1.0\r\ncomment made by hand\r\nelement camera 1\r\n"
      "property list uchar short values\r\nelement vertex 4\r\nproperty float x\r\n"
      "property uchar red\r\nproperty float y\r\nproperty float z\r\nelement face 1\r\n"
      "property uchar flags\r\nproperty list uchar ushort vertex_index\r\nend_header\r\n";
  bytes += std::string("\x02\x00\x01\x00\x02", 5);
  const std::string one("\x3f\x80\x00\x00", 4);
  const std::string zero(4, '\0');
  bytes += zero + "r" + zero + zero;
  bytes += one + "r" + zero + zero;
  bytes += one + "r" + one + zero;
  bytes += zero + "r" + one + zero;
  bytes += std::string("\x07\x04\0\0\0\1\0\2\0\3", 10);
  const IndexedMesh mesh = parse_mesh(bytes, "mesh.ply");
  CHECK(mesh.positions == std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  CHECK(mesh.triangles == decltype(mesh.triangles){{{0, 1, 2}}, {{0, 2, 3}}});
}

TEST_CASE("numbers in text are floats where PLY or VTU says so, as for other programs") {
  const auto ply = [](const std::string& type) {
    const std::string property = "\nproperty " + type;
    return parse_mesh("ply\nformat ascii 1.0\nelement vertex 1" + property + " x" + property +
                          " y" + property + " z\nend_header\n0.1 -0.3 1e-60\n",
                      "mesh.ply");
  };
  const auto vtu = [](const std::string& type) {
    const std::string array = "<DataArray format=\"ascii\" type=\"" + type + "\"";
    return parse_mesh("<VTKFile type=\"UnstructuredGrid\"><Points>" + array +
                          ">0.1 -0.3 1e-60</DataArray></Points><Cells>" + array +
                          " Name=\"connectivity\"></DataArray>" + array +
                          " Name=\"offsets\"></DataArray>" + array +
                          " Name=\"types\"></DataArray></Cells></VTKFile>",
                      "mesh.vtu");
  };
  const Point floats(0.1F, -0.3F, 0), doubles(0.1, -0.3, 1e-60);
  CHECK(ply("float").positions == std::vector{floats});
  CHECK(vtu("Float32").positions == std::vector{floats});
  CHECK(ply("double").positions == std::vector{doubles});
  CHECK(vtu("Float64").positions == std::vector{doubles});
}

TEST_CASE("a byte in the text of a VTU file is at most 255, for VTK cuts others down to one") {
  const auto mesh = [](const std::string& largest) {
    const std::string array = "<DataArray format=\"ascii\" type=\"UInt8\"";
    return parse_mesh("<VTKFile type=\"UnstructuredGrid\"><Points>" + array + ">0 1 " + largest +
                          "</DataArray></Points><Cells>" + array + " Name=\"connectivity\"/>" +
                          array + " Name=\"offsets\"/>" + array +
                          " Name=\"types\"/></Cells></VTKFile>",
                      "mesh.vtu");
  };
  CHECK(mesh("255").positions == std::vector{Point(0, 1, 255)});
  CHECK_THROWS_WITH_AS(mesh("256"), doctest::Contains("has \"256\" in the place of a number"),
                       UnreadableInput);
}

TEST_CASE("a PLY file whose triangles turn into polygons midway is read") {
  const IndexedMesh square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{{0, 1, 2}}}};
  std::string bytes = serialized(square, MeshFormat::PlyBinary);
  bytes.replace(bytes.find("face 1"), 6, "face 2");
  bytes += std::string("\4\0\0\0\0\1\0\0\0\2\0\0\0\3\0\0\0", 17);
  CHECK(parse_mesh(bytes, "mesh.ply").triangles ==
        decltype(square.triangles){{{0, 1, 2}}, {{0, 1, 2}}, {{0, 2, 3}}});
}

TEST_CASE("an OBJ file with texture, colours, normals, negative numbers and polygons is read") {
  const IndexedMesh mesh = parse_mesh(
      "# by hand\nmtllib a.mtl\nv 0 0 0\nv 1 0 0 1.0\nv 1 1 0 0.2 0.4 0.6\nv 0 1 0\nvt 0 0\nvn 0 0 "
      "1\n"
      "f 1/1/1 2//1 3/1 \\\n 4\nf -4 -3 -1 # a comment\n",
      "mesh.obj");
  CHECK(mesh.triangles == decltype(mesh.triangles){{{0, 1, 2}}, {{0, 2, 3}}, {{0, 1, 3}}});
}

TEST_CASE("an OFF file with comments, colours and counts on the first line is read") {
  const IndexedMesh mesh = parse_mesh(
      "\xEF\xBB\xBFOFF 4 1 0 # square\n\n0 0 0\r\n1 0 0\n+1 1 0\n0 1 0\n4 0 1 2 3 255 0 0\n",
      "mesh.off");
  CHECK(mesh.positions[2] == Point(1, 1, 0));
  CHECK(mesh.triangles.size() == 2);
}

TEST_CASE("the content decides the format where the ending is wrong") {
  for (const MeshFormat format : read_formats) {
    CAPTURE(ending_of(format));
    CHECK(parse_mesh(serialized(plain_tetrahedron(), format), "mesh.bin").triangles.size() == 4);
  }
}

TEST_CASE("a file that cannot be read is told apart from a bad one") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH_AS(read_mesh(folder / "none.ply"), doctest::Contains("cannot be opened"),
                       UnreadableInput);
  CHECK_THROWS_WITH_AS(read_mesh(folder / ""), doctest::Contains("is a folder"), UnreadableInput);
}

TEST_CASE("a file that cannot be written leaves nothing behind and the old file as it was") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH_AS(write_mesh(folder / "none/mesh.ply", plain_tetrahedron()),
                       doctest::Contains("create the folder first"), UnwritableOutput);
  CHECK_THROWS_WITH_AS(write_mesh(folder / "", plain_tetrahedron(), MeshFormat::Off),
                       doctest::Contains("name a file"), UnwritableOutput);
  CHECK_THROWS_WITH_AS(write_mesh(folder / "mesh.txt", plain_tetrahedron()),
                       doctest::Contains("use .ply"), UnwritableOutput);
  CHECK(folder.file_count() == 0);
  // An old file, and no way to write a new one beside it.
  write_mesh(folder / "old.ply", plain_tetrahedron());
  const std::string old = bytes_of(folder / "old.ply");
  CHECK_THROWS_AS(write_mesh(folder / "old.ply/new.ply", plain_tetrahedron()), UnwritableOutput);
  CHECK(bytes_of(folder / "old.ply") == old);
  CHECK(folder.file_count() == 1);
}
