// Mesh files that are wrong, cut short or damaged: turned down with a reason, and never worse.

#include <algorithm>
#include <ranges>

#include "tests/support/mesh_file_cases.h"

using namespace morskin;
using namespace morskin::geometry;
using namespace morskin::support;

TEST_CASE("a bad mesh is turned down with its line and a reason") {
  check_refused("OFF\n1 0 0\n0 0 nan\n", "a.off", "a.off:3: coordinate \"nan\"");
  check_refused("OFF\n1 1 0\n0 0 0\n3 0 0 1\n", "a.off", "a.off:4: corner \"1\"");
  check_refused("OFF\n1 1 0\n0 0 0\n3 0 0 -1\n", "a.off", "a.off:4: corner");
  check_refused("OFF\n1 1 0\n0 0 0\n2 0 0\n", "a.off", "three corners");
  check_refused("OFF\n2 0 0\n0 0 0\n", "a.off", "ends before its last vertex");
  check_refused("OFF 3 1 0\n0 0 0 1 0 0 0 1 0\n3 0 1 2\n", "a.off",
                "each vertex on a line of its own");
  check_refused("OFF\n1 2 0\n0 0 0\n3 0 0 0 3 0 0 0\n", "a.off", "each face on a line of its own");
  check_refused("OFF\n1 1 0\n0 0 0\n0.5 0 0\n", "a.off", "the number of a face's corners, found");
  check_refused("OFF\n1 x\n", "a.off", "a.off:2: expected the numbers of vertices");
  check_refused("v 0 0\nf 1 1 1\n", "a.obj", "a.obj:1:");
  check_refused("v 0 0 0\nf 1 1 2\n", "a.obj", "a.obj:2: corner 2");
  check_refused("v 0 0 0\nf 1 1 -2\n", "a.obj", "a.obj:2: corner \"-2\"");
  check_refused("v 0 0 inf\n", "a.obj", "not finite");
  check_refused("v 0 0 0\nv 2 0 0 2\n", "a.obj", "a.obj:2: a vertex has the weight \"2\"");
  check_refused("once upon a time\n", "a.obj", "holds no vertex");
  check_refused("solid\nfacet normal 0 0 1\nvertex 0 0 0\nendfacet\nendsolid", "a.stl",
                "a.stl:4: a facet needs three");
  const std::string facet =
      "facet normal 0 0 1\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendfacet\n";
  check_refused("solid\n" + facet + "endfacet\nendsolid", "a.stl", "a.stl:7: a facet needs three");
  check_refused("garbage", "a.stl", "no STL file");
  check_refused("garbage", "a.txt", "recognised");
  check_refused("", "a.ply", "is empty");
  check_refused("<VTKFile/>", "a.vtu",
                "a.vtu: has no array of cells called connectivity; write it again");
  check_refused("PK", "a.npz", "only written");
}

TEST_CASE("a mesh file that goes on behind what it counts is turned down, padding aside") {
  const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  check_refused(off + off, "a.off", "a.off:7: the file goes on behind the last of its 1 faces");
  check_refused(replaced(off, "3 1 0", "3 0 0"), "a.off", "the last of its 0 faces");
  CHECK(complaint(off + "\n# written by hand\n", "a.off").empty());
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty double x\nproperty double y\n"
      "property double z\nend_header\n";
  const std::string text = header + "0 0 0";
  check_refused(text + " 1\n", "a.ply", "a.ply:8: the file goes on");
  check_refused(text + "\n" + text, "a.ply", "a.ply:8: the file goes on");
  CHECK(complaint(text + "\n\n", "a.ply").empty());
  const std::string binary = replaced(header, "ascii", "binary_little_endian");
  const std::string bytes = binary + std::string(24, '\0');
  check_refused(bytes + "\1", "a.ply", "byte 24 of the body: the file goes on");
  CHECK(complaint(bytes + std::string(5, '\0') + "\n", "a.ply").empty());
}

TEST_CASE("a carriage return alone, which ends a line for some programs only, is turned down") {
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  check_refused("# by hand\rv 9 9 9\n" + obj, "a.obj", "a.obj:1: a carriage return");
  check_refused("OFF\n1 0 0\n# first\r7 7 7\n0 0 0\n", "a.off", "a.off:3: a carriage return");
  check_refused("solid a\rendsolid\n", "a.stl", "a.stl:1: a carriage return");
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\nend_header\n0 0 0\n";
  check_refused(replaced(ply, "element", "comment\relement"), "a.ply",
                "a.ply:3: a carriage return");
  check_refused(replaced(ply, "0 0 0", "0\r0 0"), "a.ply", "a.ply:8: a carriage return");
  CHECK_THROWS_WITH_AS(parse_msms("0 0 0 0 0 1 0 1 1\r0 0 0 0 0 1 0 1 1\n", "a.vert", "", "a.face"),
                       doctest::Contains("a.vert:1: a carriage return"), UnreadableInput);
  const std::string msh = serialized(plain_tetrahedron(), MeshFormat::Msh);
  check_refused(replaced(msh, "$Nodes\n", "$Nodes\r"), "a.msh", "a carriage return");
  CHECK(parse_mesh(obj + "# at the end\r\n", "a.obj").positions.size() == 3);
}

TEST_CASE("a comment or a name of an OBJ file that ends in a backslash is turned down") {
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  for (const std::string start : {"# a\\b", "g a ", "f 1 2 3 # a"}) {
    check_refused(obj + start + "\\\nf 1 2 3\n", "a.obj", "a.obj:5: a backslash ends a comment");
  }
  check_refused(obj + "f 1 \\\n2 3 # a \\\nf 1 2 3\n", "a.obj", "a.obj:6: a backslash");
  CHECK(complaint(obj + "# a\\", "a.obj").empty());
}

TEST_CASE("a bad PLY mesh is turned down with a reason") {
  const std::string start = "ply\nformat ascii 1.0\nelement vertex ";
  const std::string middle = "\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  check_refused(start + "1" + middle + faces + "0 0 nan\n3 0 0 0\n", "a.ply",
                "vertex 0 has a coordinate that is not finite");
  check_refused(start + "1" + middle + faces + "0 0 0\n3 0 0 1\n", "a.ply",
                "corner 1 but there are only 1");
  check_refused(start + "1" + middle + faces + "0 0 0\n3 0 0 -1\n", "a.ply",
                "a.ply:11: -1 is no corner or count");
  check_refused(start + "1" + middle + faces + "0 0 x\n3 0 0 0\n", "a.ply",
                "a.ply:10: \"x\" is no number");
  check_refused(start + "1" + middle + "end_header\n0 0\n", "a.ply", "too");
  check_refused(start + "1" + replaced(middle, "float", "int") + faces + "0.5 0 0\n3 0 0 0\n",
                "a.ply", "a.ply:10: \"0.5\" is no number of its property's type");
  check_refused(start + "1" + middle + replaced(faces, " int", " uchar") + "0 0 0\n3 0 0 256\n",
                "a.ply", "\"256\" is no number of its property's type");
  check_refused(start + "1\nproperty float x\nend_header\n0\n", "a.ply", "x, y and z");
  check_refused(start + "1" + middle + "end_header\n0 1e39 0\n", "a.ply", "not finite");
  check_refused(
      start + "1\nproperty float x\nproperty float x\nproperty float y\n" + "end_header\n0 0 0\n",
      "a.ply", "x, y and z");
  check_refused(
      start + "1" + middle + "element vertex 1" + middle + faces + "0 0 0\n0 0 0\n3 0 0 0\n",
      "a.ply", "two elements \"vertex\"");
  check_refused(start + "1" + middle +
                    replaced(faces, "end", "property list uchar int vertex_index\nend") +
                    "0 0 0\n3 0 0 0 3 0 0 0\n",
                "a.ply", "two lists of corners");
  check_refused("ply\nformat ascii 1.0\n", "a.ply", "does not end");
  check_refused("ply\nend_header\n", "a.ply", "no format");
}

TEST_CASE(
    "what other readers of VTU files pass over is not read, and what is there twice refused") {
  const IndexedMesh mesh = plain_tetrahedron();
  IndexedMesh other = mesh;
  other.positions[3].z() = 7;
  const std::string text = serialized(mesh, MeshFormat::Vtu);
  const auto section = [](const std::string& of, const std::string& name) {
    const std::size_t begin = of.find("<" + name + ">"), end = of.find("</" + name + ">");
    return of.substr(begin, end + name.size() + 3 - begin);
  };
  const auto with = [&](const std::string& old, const std::string& added) {
    return replaced(text, old, old + added);
  };
  const std::string points = section(serialized(other, MeshFormat::Vtu), "Points");
  const std::string cells = section(text, "Cells");
  CHECK(parse_mesh(with("</Cells>", "<!-- <old/>" + points + "-->"), "a.vtu") == mesh);
  check_refused(with("</Cells>", points), "a.vtu", "several arrays of points");
  check_refused(with("</Cells>", cells), "a.vtu", "several arrays of cells called \"connect");
  check_refused(with("</Cells>", "<![CDATA[ <old/>" + points + "]]>"), "a.vtu", "CDATA");
  check_refused(with("</Cells>", "<?old <old/>" + points + "?>"), "a.vtu", "?old");
  for (const std::string count : {"NumberOfPoints=\"4", "NumberOfCells=\"4"}) {
    check_refused(with(count, "0"), "a.vtu", "more or fewer points or cells");
  }
}

TEST_CASE("a VTU array that ends inside a number is turned down, however long it says it is") {
  const std::string text = serialized(plain_tetrahedron(), MeshFormat::Vtu);
  // The lengths of the arrays of points and of corners, 96 bytes, and with one more 97.
  const std::string length = ">YAAAAAAAAA", longer = ">YQAAAAAAAA";
  CHECK(text.find(length) != text.rfind(length));
  for (const std::size_t at : {text.find(length), text.rfind(length)}) {
    std::string damaged = text;
    const std::size_t padding = damaged.find("=</DataArray>", at);
    damaged[padding] = 'A';
    std::ranges::copy(longer, damaged.begin() + static_cast<std::ptrdiff_t>(at));
    check_refused(damaged, "a.vtu", "an array that is damaged");
  }
}

TEST_CASE("a VTU file whose tags are not closed in turn is no XML, and is turned down") {
  const std::string text = serialized(plain_tetrahedron(), MeshFormat::Vtu);
  check_refused(replaced(text, "</VTKFile>", ""), "a.vtu", "ends before \"VTKFile\" is closed");
  check_refused(replaced(text, "</Cells>", ""), "a.vtu", "closes \"Piece\"");
  check_refused(text + "</VTKFile>", "a.vtu", "closes \"VTKFile\"");
  // Quotes may hold what ends a tag elsewhere.
  CHECK(parse_mesh(replaced(text, "</Cells>", "</Cells><A b='>' c=\"/>\"><B c='>'/></A>"),
                   "a.vtu") == plain_tetrahedron());
}

TEST_CASE(
    "what other readers of MSH files pass over is not read, and what is there twice refused") {
  const IndexedMesh mesh = plain_tetrahedron();
  IndexedMesh other = mesh;
  other.positions[3].z() = 7;
  const std::string text = serialized(mesh, MeshFormat::Msh);
  const auto section = [](const std::string& of, const std::string& name) {
    const std::size_t begin = of.find("$" + name), end = of.find("$End" + name);
    return of.substr(begin, end + name.size() + 5 - begin);
  };
  const std::string nodes = section(serialized(other, MeshFormat::Msh), "Nodes");
  CHECK(parse_mesh(replaced(text, "Angstrom\n", "Angstrom\n" + nodes), "a.msh") == mesh);
  check_refused(text + nodes, "a.msh", "two sections of nodes");
  check_refused(text + section(text, "Elements"), "a.msh", "two sections of elements");
  for (const std::string end : {"$EndNodes\n", "$EndElements\n"}) {
    check_refused(replaced(text, end, ""), "a.msh", "ends too early");
  }
  const std::string block = "$Elements\n1 4 1 4\n";
  check_refused(replaced(text, block + "2 1 2", block + "1 1 2"), "a.msh", "have the dimension 1");
  check_refused(replaced(text, block + "2 1 2", block + "1 1 3"), "a.msh", "elements of type 3");
  for (const std::string name : {"Nodes", "Elements"}) {
    const std::string head = "$" + name + "\n1 ";
    check_refused(replaced(text, head + "4 1 4", head + "5 1 4"), "a.msh",
                  "where 5 were announced");
  }
}

TEST_CASE("a count beyond what the file can hold is turned down and not allocated") {
  const std::string properties = "\nproperty double x\nproperty double y\nproperty double z\n";
  for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    for (const std::string count : {"1000000000000", "9223372036854775807", "4000000000"}) {
      const std::string header = "ply\nformat " + format + " 1.0\nelement vertex ";
      check_refused(header + count + properties + "end_header\n", "a.ply", "");
      check_refused(header + "0" + properties + "element face " + count +
                        "\nproperty list uchar int vertex_indices\nend_header\n",
                    "a.ply", "");
      check_refused(
          header + "0" + properties + "element edge " + count + "\nproperty int a\nend_header\n",
          "a.ply", "");
    }
  }
  check_refused("OFF\n1000000000000 0 0\n", "a.off", "");
  check_refused("OFF\n1 1000000000000 0\n0 0 0\n", "a.off", "");
  check_refused("OFF\n1 1 0\n0 0 0\n1000000000000 0\n", "a.off", "");
  check_refused(std::string(80, ' ') + "\xff\xff\xff\xff", "a.stl", "");
}

TEST_CASE("a mesh cut short anywhere is turned down or the same, of OBJ its first triangles") {
  // Nothing tells that the last number of a text has lost digits, so here it has one.
  const IndexedMesh mesh = plain_tetrahedron();
  for (const MeshFormat format : read_formats) {
    CAPTURE(ending_of(format));
    const std::string bytes = serialized(mesh, format);
    const IndexedMesh whole = parse_mesh(bytes, ending_of(format));
    REQUIRE(whole.triangles.size() == 4);
    std::size_t read = 0;
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      CAPTURE(size);
      IndexedMesh cut;
      try {
        cut = parse_mesh(bytes.substr(0, size), ending_of(format));
      } catch (const UnreadableInput&) {
        continue;
      }
      ++read;
      if (format != MeshFormat::Obj) {
        CHECK(cut == whole);
      } else if (!cut.triangles.empty()) {  // the file does not say how many there are
        CHECK(cut.positions == whole.positions);
        CHECK(std::mismatch(cut.triangles.begin(), cut.triangles.end(), whole.triangles.begin(),
                            whole.triangles.end())
                  .first == cut.triangles.end());
      }
    }
    // Of a text the end of the last line may be missing.
    const bool is_binary = format == MeshFormat::PlyBinary || format == MeshFormat::Stl;
    if (format != MeshFormat::Obj) CHECK(read == (is_binary ? 0 : 1));
  }
}

TEST_CASE("a mesh with flipped bits is read or turned down, never worse") {
  for (const MeshFormat format : read_formats) {
    const std::string bytes = serialized(awkward_tetrahedron(), format);
    for (unsigned seed = 0; seed < 2000; ++seed) {
      std::mt19937 random(seed);
      std::string damaged = bytes;
      for (unsigned flip = 0; flip <= seed % 4; ++flip) {
        char& victim = damaged[random() % damaged.size()];
        victim = static_cast<char>(victim ^ (1 << random() % 8));
      }
      CAPTURE(ending_of(format));
      CAPTURE(seed);
      try {
        const IndexedMesh mesh = parse_mesh(damaged, ending_of(format));
        for (const auto& triangle : mesh.triangles) {
          for (const std::uint32_t corner : triangle) REQUIRE(corner < mesh.positions.size());
        }
        for (const Point& position : mesh.positions) REQUIRE(position.allFinite());
      } catch (const UnreadableInput&) {
      }
    }
  }
}
