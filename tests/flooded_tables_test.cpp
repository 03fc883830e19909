// Mesh files whose numbers are chosen so that a table finds them all in one place.

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>

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

double seconds_to_parse(const std::string& text, const std::string& name, std::size_t vertices) {
  const Stopwatch stopwatch;
  CHECK(parse_mesh(text, name).positions.size() == vertices);
  return stopwatch.seconds();
}

/// Both tables take some steps for each entry; a flooded one that were searched entry by entry
/// would take hundreds of times as long.
constexpr double some = 20;

}  // namespace

TEST_CASE("an STL file whose corners meet in one slot takes about as long as any") {
  constexpr std::size_t corners = 60000;
  const double usual = seconds_to_parse(stl_text(corners, false), "a.stl", corners);
  CHECK(seconds_to_parse(stl_text(corners, true), "a.stl", corners) < 0.1 + some * usual);
}
