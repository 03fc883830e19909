#pragma once

/// The arguments of the commands that draw: render and figure.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/limits.h"
#include "app/pictures/image.h"
#include "geometry/point.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's
class App;
}

namespace morskin::app {

enum class ColourBy { Nothing, Angle, Component };
enum class DrawEdges { Auto, Always, Never };  ///< Auto: where triangles are large enough

/// A second panel: its centre in the first, 0 to 1 from the top left, and its magnification.
struct Inset {
  double x = 0.5, y = 0.5, factor = 1;
};

struct RenderArguments {
  std::vector<std::filesystem::path> meshes;
  std::filesystem::path output;
  int width = 800, height = 800;  ///< of a panel, pixels
  geometry::Vector view = geometry::Vector::UnitZ(), up = geometry::Vector::UnitY();
  std::optional<geometry::Point> at;  ///< seen in the middle
  double zoom = 1;
  std::optional<Inset> inset;
  pictures::Colour colour = pictures::Colour::of(0xa9c3d9);
  ColourBy by = ColourBy::Nothing;
  DrawEdges edges = DrawEdges::Auto;
  bool flat = false;  ///< triangles as they are, not shaded as a smooth surface
  bool shadows = true;
  int columns = 3;  ///< panels in a row
  Limits limits{.advice = "draw a smaller picture or a coarser mesh"};
};

struct FigureArguments {
  std::string name;
  std::filesystem::path output;
  double scale = 1;
};

/// The options as typed, before they are checked.
struct TypedPicture {
  std::string size, view, up, at, inset, colour, by = "nothing", edges = "auto";
  bool no_shadows = false;
};

void add_render(CLI::App& app, RenderArguments& render, TypedPicture& typed);
void add_figure(CLI::App& app, FigureArguments& figure);

/// @throws UsageError
void finish(RenderArguments& render, const TypedPicture& typed);
void finish(const FigureArguments& figure);

}  // namespace morskin::app
