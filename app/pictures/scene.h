#pragma once

/// The contents of a picture: meshes, balls, sticks, lines on surfaces, labels.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "app/pictures/camera.h"
#include "app/pictures/canvas.h"
#include "geometry/indexed_mesh.h"

namespace morskin::pictures {

struct Coat {
  Colour colour = Colour::of(0xa9c3d9);
  Colour back = Colour::of(0xc79a6b);  ///< of triangles seen from inside
  double gloss = 0.25;                 ///< strength of the highlight, 0 to 1
  double edge_width = 0;               ///< of triangles' edges, pixels; 0 for none
  Colour edge = Colour::of(0x22364a);
};

struct MeshLayer {
  geometry::IndexedMesh mesh;
  std::vector<Vector> normals;           ///< unit, by vertex; empty for flat triangles
  std::vector<Colour> triangle_colours;  ///< by triangle; empty for the coat's
  Coat coat;
};
struct Ball {
  Point centre;
  double radius;  ///< Angstrom
  Colour colour;
};
struct Stick {
  Point from, to;
  double radius;
  Colour colour;
};
struct Line {
  std::vector<Point> points;
  Colour colour;
  double width = 2;        ///< pixels
  double lift = 0;         ///< offset towards the eye, Angstrom
  double dash = 0;         ///< pixels; 0 for none
  bool is_on_top = false;  ///< hidden by nothing
};
struct Label {
  Point at;
  std::string text;
  Vector2 shift = Vector2::Zero();  ///< pixels, right and down
  double size = 13;                 ///< of capitals, pixels
  Colour colour = ink;
};

struct Scene {
  std::vector<MeshLayer> meshes;
  std::vector<Ball> balls;
  std::vector<Stick> sticks;
  std::vector<Line> lines;
  std::vector<Label> labels;

  /// The corners of a box about each thing: enough to fit a camera.
  std::vector<Point> extent() const;
};

/// Unit normals by vertex: the mean of its triangles', weighted by their angles.
std::vector<Vector> smooth_normals(const geometry::IndexedMesh& mesh);

/// The edges that only one triangle has, as pairs of vertices; of those between the same positions
/// the first.
std::vector<std::array<std::uint32_t, 2>> boundary_edges(const geometry::IndexedMesh& mesh);

/// Takes out each triangle with the positions and the orientation of an earlier one, which hides
/// it.
void drop_copies(geometry::IndexedMesh& mesh);

}  // namespace morskin::pictures
