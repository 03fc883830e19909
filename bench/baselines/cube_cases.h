#pragma once

/// The 256 ways in which a surface can pass between the corners of a cube, as triangles.
///
/// Corner c of the unit cube lies at the bits of c: x is bit 0, y bit 1, z bit 2. Edge 4 a + i runs
/// along axis a; the bits of i are the other two coordinates, those of the axis after a first. A
/// case is the set of corners inside the body, one bit each.
///
/// Nothing is written down by hand. On each face a segment cuts off every run of inside corners, so
/// that inside corners on a diagonal stay apart. Both cubes at a face see the same corners and so
/// the same segments: the surfaces in them fit. The segments of a cube join up to closed loops, and
/// each loop is cut into triangles, with no cut along a face: so two cubes never share a cut, and
/// the surface is a closed 2-manifold. That such cuts exist is checked while this is compiled.

#include <array>
#include <cstddef>
#include <cstdint>

namespace morskin::baselines {

inline constexpr std::size_t cube_edge_count = 12;

struct CubeCase {
  /// Corners of the triangles: edges of the cube, counter-clockwise seen from outside the body.
  std::array<std::array<std::uint8_t, 3>, 5> triangles{};
  std::uint8_t count = 0;
};

/// Where an edge of the cube starts, at its lower end, and the axis it runs along.
struct CubeEdge {
  std::uint8_t corner;
  std::uint8_t axis;
};
constexpr CubeEdge cube_edge(std::size_t edge) {
  const std::size_t a = edge / 4, i = edge % 4;
  const std::size_t corner = (i & 1) << (a + 1) % 3 | (i >> 1) << (a + 2) % 3;
  return {static_cast<std::uint8_t>(corner), static_cast<std::uint8_t>(a)};
}

/// By the set of inside corners.
extern const std::array<CubeCase, 256> cube_cases;

}  // namespace morskin::baselines
