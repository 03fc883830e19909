// Mesh files that say something else than they hold, or that programs read in several ways: one by
// one, each would be read as another mesh if its line of the reader were missing.

#include "tests/support/mesh_file_cases.h"

using namespace morskin;
using namespace morskin::geometry;
using namespace morskin::support;

namespace {

const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
const std::string facet_begin = "facet normal 0 0 1\nouter loop\n";
const std::string facet_end = "endloop\nendfacet\n";
const std::string facet_corners = "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n";

IndexedMesh msms(const std::string& vertices, const std::string& faces) {
  return parse_msms(vertices, "a.vert", faces, "a.face");
}

std::string array(const std::string& name, const std::string& numbers) {
  return "<DataArray format=\"ascii\" type=\"Float64\" Name=\"" + name + "\">" + numbers +
         "</DataArray>";
}

/// A square in a VTU file, whose cells are of these corners, ends and types.
std::string vtu(const std::string& corners, const std::string& ends, const std::string& types) {
  return "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece><Points>" +
         array("Points", square) + "</Points><Cells>" + array("connectivity", corners) +
         array("offsets", ends) + array("types", types) +
         "</Cells></Piece></UnstructuredGrid></VTKFile>";
}

}  // namespace

TEST_CASE("OFF with a fourth coordinate, in other dimensions or binary is turned down as such") {
  const std::string body = "4 1 0\n0 0 0 1\n1 0 0 1\n1 1 0 1\n0 1 0 1\n3 0 1 2\n";
  for (const std::string word : {"4OFF", "nOFF", "4nOFF", "ST4OFF"}) {
    check_refused(word + "\n" + body, "a.off", "expected OFF for points in space");
  }
  CHECK(parse_mesh("COFF\n" + body, "a.off").triangles.size() == 1);
  check_refused("OFF BINARY\n" + body, "a.off", "binary OFF is not read");
  for (const std::string counts : {"-4 1 0", "4 -1 0"}) {
    check_refused("OFF\n" + counts + "\n" + square, "a.off", "expected the numbers of vertices");
  }
}

TEST_CASE("an OBJ face of two corners, or with a corner that no vertex has, is turned down") {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n", later = "v 1 1 0\n";
  check_refused(vertices + "f 1 2\n", "a.obj", "a.obj:4: a face needs three corners");
  check_refused(vertices + "f 1 2 0\n" + later, "a.obj", "corner \"0\" names no vertex");
  check_refused(vertices + "f 1 2 4294967297\n", "a.obj", "names no vertex");
  CHECK(parse_mesh(vertices + "f 1 \\\n 2 \\\n 3\n", "a.obj").triangles ==
        geometry::TriangleList{{{0, 1, 2}}});
}

TEST_CASE(
    "an STL file as text that nests facets, or has vertices outside of them, is turned down") {
  const auto solid = [](const std::string& facets) { return "solid\n" + facets + "endsolid\n"; };
  const std::string facet = facet_begin + facet_corners + facet_end;
  CHECK(parse_mesh(solid(facet), "a.stl").triangles.size() == 1);
  check_refused(solid(facet_begin + facet_corners + facet), "a.stl", "a facet begins inside");
  check_refused(solid("vertex 7 7 7\n" + facet), "a.stl", "a vertex stands outside a facet");
  check_refused("solid\n" + facet, "a.stl", "the file ends inside a solid");
}

TEST_CASE("MSMS files whose faces or counts do not fit their vertices are turned down") {
  const std::string row = "0 0 0 0 0 1 0 1 1\n", vertices = row + row + row;
  CHECK(msms("3 1 0 0\n" + vertices, "1 1 0 0\n1 2 3 1 1\n").triangles.size() == 1);
  for (const std::string corners : {"0 1 2", "1 2 4", "1 2 -1", "1 2 x"}) {
    CHECK_THROWS_WITH_AS(msms(vertices, corners + " 1 1\n"),
                         doctest::Contains("a.face:1: corner \""), UnreadableInput);
  }
  for (const std::string count : {"2", "4"}) {
    CHECK_THROWS_WITH_AS(msms(count + " 1 0 0\n" + vertices, ""),
                         doctest::Contains(("promises " + count).c_str()), UnreadableInput);
  }
  CHECK_THROWS_WITH_AS(msms("x 1 0 0\n" + vertices, ""),
                       doctest::Contains("the number of vertices"), UnreadableInput);
}

TEST_CASE("a PLY file is read by the names and the byte order that its header has") {
  const IndexedMesh mesh = plain_tetrahedron();
  const std::string little = serialized(mesh, MeshFormat::PlyBinary);
  const std::size_t body = little.find("end_header\n") + 11;
  std::string turned = little;  // y, x, z
  turned[little.find("double x") + 7] = 'y';
  turned[little.find("double y") + 7] = 'x';
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    CHECK(parse_mesh(turned, "a.ply").positions[v] ==
          Point(mesh.positions[v].y(), mesh.positions[v].x(), mesh.positions[v].z()));
  }
  std::string big = replaced(little.substr(0, body), "little", "big");
  const auto append = [&](std::size_t begin, std::size_t size) {
    for (std::size_t i = size; i-- > 0;) big += little[begin + i];
  };
  for (std::size_t k = 0; k < 3 * mesh.positions.size(); ++k) append(body + 8 * k, 8);
  for (std::size_t at = body + 24 * mesh.positions.size(); at < little.size(); at += 13) {
    append(at, 1);
    for (std::size_t k = 0; k < 3; ++k) append(at + 1 + 4 * k, 4);
  }
  CHECK(parse_mesh(big, "a.ply") == mesh);
}

TEST_CASE("a PLY file with faces that are none, or with what is not read, is turned down") {
  const auto ply = [](const std::string& faces, const std::string& rows) {
    return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
           "property float z\n" +
           faces + "end_header\n" + square + rows;
  };
  const std::string list = "property list uchar float vertex_indices\n";
  const std::string face = "element face 1\n" + list;
  CHECK(parse_mesh(ply(face, "3 0 1 2\n"), "a.ply").triangles.size() == 1);
  check_refused(ply(face, "3 0 1 1.5\n"), "a.ply", "1.5 is no corner or count");
  check_refused(ply(face, "2 0 1\n"), "a.ply", "face 0 has 2 corners");
  check_refused(ply(face + face, "3 0 1 2\n3 0 1 2\n"), "a.ply", "two elements \"face\"");
  check_refused(ply("element tristrips 1\n" + list, "4 0 1 2 3\n"), "a.ply", "strips are not read");
  // Elements without properties take no bytes, and no time.
  const std::string nothing = "element nothing 1000000000000000000\n";
  CHECK(parse_mesh(ply(nothing, ""), "a.ply").positions.size() == 4);
  check_refused("ply\nformat ascii 1.0\nelement edge 1\nproperty int a\nend_header\n1\n", "a.ply",
                "has no vertices");
  check_refused(replaced(ply("", ""), "float z", "list uchar float z"), "a.ply", "x, y and z");
}

TEST_CASE("VTU cells that do not fit their corners or points are turned down") {
  CHECK(parse_mesh(vtu("0 1 2 0 2 3", "3 6", "5 5"), "a.vtu").triangles.size() == 2);
  check_refused(vtu("0 1 2 0 2 3", "3 6", "5"), "a.vtu", "more or fewer cell types than cells");
  check_refused(vtu("0 1 2 0 2 3", "3 7", "5 5"), "a.vtu", "cell 1 has not the corners");
  check_refused(vtu("0 1 2 3 0 2 3", "4 7", "5 5"), "a.vtu", "cell 0 has not the corners");
  check_refused(vtu("0 1 2 0 2", "3 6", "5 5"), "a.vtu", "cell 1 has not the corners");
  for (const std::string corner : {"-1", "4", "1.5", "inf"}) {
    check_refused(vtu("0 1 " + corner, "3", "5"), "a.vtu",
                  corner == "inf" ? "\"inf\" in the place of a number" : "a corner that does not");
  }
  check_refused(replaced(vtu("0 1 2", "3", "5"), "0 1 0\n", "0 1\n"), "a.vtu",
                "points without three coordinates");
}

TEST_CASE("VTU files of other kinds are turned down, and lengths of 32 bits read") {
  const std::string good = vtu("0 1 2", "3", "5");
  const auto with = [&](const std::string& attribute) {
    return replaced(good, "<VTKFile", "<VTKFile " + attribute);
  };
  CHECK(parse_mesh(with("byte_order=\"LittleEndian\""), "a.vtu") == parse_mesh(good, "a.vtu"));
  check_refused(with("byte_order=\"BigEndian\""), "a.vtu", "big-endian");
  check_refused(with("compressor=\"vtkZLibDataCompressor\""), "a.vtu", "compressed");
  check_refused(replaced(good, "type=\"Unstr", "type=\"Str"), "a.vtu", "no unstructured grid");
  check_refused(replaced(good, "</Piece>", "</Piece><Piece></Piece>"), "a.vtu", "several pieces");
  // The length of one byte, in four and in eight, and the type of a triangle.
  for (const auto& [head, data] :
       {std::pair("UInt32", "AQAAAAU="), std::pair("UInt64", "AQAAAAAAAAAF")}) {
    std::string binary = with("header_type=\"" + std::string(head) + "\"");
    const std::string types = array("types", "5");
    binary = replaced(binary, types,
                      "<DataArray format=\"binary\" type=\"UInt8\" Name=\"types\">" +
                          std::string(data) + "</DataArray>");
    CHECK(parse_mesh(binary, "a.vtu") == parse_mesh(good, "a.vtu"));
  }
}

TEST_CASE("a coordinate that is not finite is turned down in every format") {
  for (const MeshFormat format : read_formats) {
    for (const double bad : {std::numeric_limits<double>::infinity(), std::nan("")}) {
      CAPTURE(ending_of(format));
      IndexedMesh mesh = plain_tetrahedron();
      mesh.positions[1].y() = bad;
      check_refused(serialized(mesh, format), ending_of(format), "not finite");
    }
  }
}
