// Mesh files whose numbers are chosen so that a table finds them all in one place.

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>

#include "geometry/error.h"
#include "geometry/files/mesh_files.h"
#include "geometry/files/text_lines.h"
#include "geometry/stopwatch.h"

using namespace morskin::geometry;

namespace {

/// The hash of geometry/files/stl_file.cpp, which a file can invert.
constexpr std::uint64_t factor = 0x9E3779B97F4A7C15ULL;

std::uint64_t mixed(std::uint64_t hash, double x) {
  hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * factor;
  return hash ^ hash >> 32;
}

/// A third coordinate with which the hash ends in 24 zeros; not always finite.
double flooding(double x, double y, std::uint64_t random) {
  std::uint64_t inverse = factor;  // of an odd number, by Newton's method
  for (int i = 0; i < 5; ++i) inverse *= 2 - factor * inverse;
  const std::uint64_t wanted = random << 24, before = wanted ^ wanted >> 32;
  return std::bit_cast<double>(before * inverse ^ mixed(mixed(0, x), y));
}

std::string stl_text(std::size_t corners, bool is_flooding) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> share(0, 1);
  std::string text = "solid\n";
  for (std::size_t i = 0; i < corners;) {
    const double x = share(random), y = share(random);
    const double z = is_flooding ? flooding(x, y, random()) : share(random);
    if (!std::isfinite(z)) continue;
    if (i % 3 == 0) text += "facet\n";
    for (const double coordinate : {x, y, z}) {
      text += coordinate == x ? "vertex " : " ";
      append_number(text, coordinate);
    }
    text += ++i % 3 == 0 ? "\nendfacet\n" : "\n";
  }
  return text + "endsolid\n";
}

/// Nodes with tags that are multiples of `step`, and one triangle.
std::string msh_text(std::uint64_t nodes, std::uint64_t step) {
  std::string text = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 " + std::to_string(nodes) +
                     " 1 1\n2 1 0 " + std::to_string(nodes) + "\n";
  for (std::uint64_t i = nodes; i > 0; --i) text += std::to_string(i * step) + "\n";
  for (std::uint64_t i = 0; i < nodes; ++i) text += "0 0 " + std::to_string(i) + "\n";
  return text + "$EndNodes\n$Elements\n1 1 1 1\n2 1 2 1\n1 " + std::to_string(step) + " " +
         std::to_string(2 * step) + " " + std::to_string(3 * step) + "\n$EndElements\n";
}

double seconds_to_parse(const std::string& text, const std::string& name, std::size_t vertices) {
  const Stopwatch stopwatch;
  CHECK(parse_mesh(text, name).positions.size() == vertices);
  return stopwatch.seconds();
}

/// A table that is searched entry by entry would take hundreds of times as long.
constexpr double some = 20;

}  // namespace

TEST_CASE("an STL file whose corners meet in one slot takes about as long as any") {
  constexpr std::size_t corners = 60000;
  const double usual = seconds_to_parse(stl_text(corners, false), "a.stl", corners);
  CHECK(seconds_to_parse(stl_text(corners, true), "a.stl", corners) < 0.1 + some * usual);
}

TEST_CASE("an MSH file whose tags a hash table would find in one place is read as fast as any") {
  // Numbers of places that libstdc++ takes for so many entries.
  constexpr std::uint64_t nodes = 85000, places = 42043, more_places = 85229;
  const double usual = seconds_to_parse(msh_text(nodes, 1), "a.msh", nodes);
  CHECK(seconds_to_parse(msh_text(nodes, places * more_places), "a.msh", nodes) <
        0.1 + some * usual);
}

TEST_CASE("nodes of an MSH file are found by any tags, and one tag is not taken twice") {
  const IndexedMesh mesh = parse_mesh(msh_text(5, 1000), "a.msh");
  CHECK(mesh.triangles == TriangleList{{4, 3, 2}});
  std::string text = msh_text(5, 1);
  text.replace(text.find("\n4\n3\n"), 5, "\n3\n3\n");
  const auto fails_with = [](const std::string& bytes, const std::string& what) {
    try {
      parse_mesh(bytes, "a.msh");
      return false;
    } catch (const UnreadableInput& error) {
      return std::string(error.what()).find(what) != std::string::npos;
    }
  };
  CHECK(fails_with(text, "two nodes have the tag 3"));
  for (const std::string missing : {"0", "6", "9223372036854775807"}) {
    CAPTURE(missing);
    std::string other = msh_text(5, 1);
    other.replace(other.find("1 1 2 3\n"), 3, "1 " + missing);
    CHECK(fails_with(other, "a node does not exist"));
  }
}
