#include "app/picture_arguments.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <string_view>

#include "app/arguments.h"
#include "app/figures/figures.h"
#include "app/output_names.h"
#include "app/shared_options.h"
#include "geometry/files/text_lines.h"

namespace morskin::app {
namespace {

constexpr double max_zoom = 1e6;
constexpr double max_pixels = 1 << 25;  // with nine samples each: 300 million

// "1.5,2,3", as many numbers as wanted.
std::vector<double> numbers(std::string_view text, std::size_t count, char separator,
                            const std::string& complaint) {
  std::vector<double> values;
  for (;;) {
    const std::size_t end = std::min(text.find(separator), text.size());
    const std::optional<double> value = geometry::parse_double(text.substr(0, end));
    if (!value || !std::isfinite(*value)) throw UsageError(complaint);
    values.push_back(*value);
    if (end == text.size()) break;
    text.remove_prefix(end + 1);
  }
  if (values.size() != count) throw UsageError(complaint);
  return values;
}

geometry::Vector vector(std::string_view text, const std::string& option) {
  const std::vector<double> v = numbers(text, 3, ',', option + " needs three numbers: x,y,z");
  return {v[0], v[1], v[2]};
}

geometry::Vector direction(std::string_view text, const std::string& option) {
  const geometry::Vector v = vector(text, option);
  if (v.isZero(0)) throw UsageError(option + " needs a direction that is not zero");
  // Of any length, by a power of two first: exact, and its square no overflow.
  const int exponent = std::ilogb(v.cwiseAbs().maxCoeff());
  return v.unaryExpr([=](double x) { return std::scalbn(x, -exponent); }).normalized();
}

pictures::Colour parsed_colour(std::string_view text) {
  if (text.starts_with('#')) text.remove_prefix(1);
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  if (text.size() != 6 || error != std::errc() || end != text.data() + text.size()) {
    throw UsageError("--colour needs six hexadecimal digits, as in #a9c3d9");
  }
  return pictures::Colour::of(value);
}

void set_size(RenderArguments& render, std::string_view text) {
  const std::string complaint =
      "--size needs pixels, as in 800 or 1200x800, at most 32 million of them";
  const bool is_square = text.find('x') == std::string_view::npos;
  const std::vector<double> v = numbers(text, is_square ? 1 : 2, 'x', complaint);
  const double width = v.front(), height = v.back();
  if (!(width >= 1 && height >= 1 && width * height <= max_pixels) || width != std::floor(width) ||
      height != std::floor(height)) {
    throw UsageError(complaint);
  }
  render.width = static_cast<int>(width);
  render.height = static_cast<int>(height);
}

void check_png(const std::filesystem::path& output) {
  if (!is_standard_output(output) && lower_extension(output) != ".png") {
    throw UsageError(output.string() + ": pictures are written as .png");
  }
}

}  // namespace

void add_render(CLI::App& app, RenderArguments& render, TypedPicture& typed) {
  CLI::App& command = *app.add_subcommand("render", "Draw meshes as a PNG");
  command
      .add_option("MESH", render.meshes,
                  "PLY, OFF, OBJ, STL, VTU, MSH or MSMS, of any tool; several get a panel each,\n"
                  "all seen by the same camera")
      ->required();
  command.add_option("-o,--output", render.output, "The PNG; - for standard output")->required();
  command.add_option("--size", typed.size, "Of a panel, pixels: 800 or 1200x800 (default: 800)");
  command.add_option("--view", typed.view, "x,y,z: from where it is seen (default: 0,0,1)");
  command.add_option("--up", typed.up, "x,y,z: upwards in the picture (default: 0,1,0)");
  command.add_option("--at", typed.at, "x,y,z: the point in the middle (default: all in view)");
  command.add_option("--zoom", render.zoom, "How many times larger than all in view");
  command.add_option("--inset", typed.inset,
                     "x,y,factor: a point of the first panel, 0 to 1 from its top left, to be\n"
                     "shown so many times larger in a last panel");
  command.add_option("--colour", typed.colour, "Of the surface (default: #a9c3d9)");
  add_choice(command, "--by", typed.by, {"nothing", "angle", "component"},
             "Colour triangles by nothing, angle (the smallest) or component");
  add_choice(command, "--edges", typed.edges, {"auto", "always", "never"},
             "Draw edges: always, never, or auto, where triangles are large enough");
  command.add_flag("--flat", render.flat, "Show triangles flat, not as a smooth surface");
  command.add_flag("--no-shadows", typed.no_shadows, "Draw no shadows; faster");
  command.add_option("--columns", render.columns, "Panels in a row")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  command.footer(
      "Edges with one triangle only, a front or a hole, are red. A legend below tells\n"
      "what the colours mean.");
}

void add_figure(CLI::App& app, FigureArguments& figure) {
  CLI::App& command = *app.add_subcommand("figure", "Draw a figure of the paper as a PNG");
  command.add_option("NUMBER", figure.name, "The figure's number")->required();
  command.add_option("-o,--output", figure.output, "The PNG; - for standard output")->required();
  command.add_option("--scale", figure.scale, "Factor for its size")->capture_default_str();
  std::string list = "Figures:\n";
  for (const figures::Figure& f : figures::all_figures()) {
    list += "  " + std::string(f.name) + std::string(14 - f.name.size(), ' ') +
            std::string(f.caption) + "\n";
  }
  command.footer(list);
}

void finish(RenderArguments& render, const TypedPicture& typed) {
  check_png(render.output);
  for (const std::filesystem::path& mesh : render.meshes) {
    check_not_input(render.output, {.input = mesh});
  }
  if (!typed.size.empty()) set_size(render, typed.size);
  if (!typed.view.empty()) render.view = direction(typed.view, "--view");
  if (!typed.up.empty()) render.up = direction(typed.up, "--up");
  if (!typed.at.empty()) render.at = vector(typed.at, "--at");
  if (!(render.zoom > 0 && render.zoom <= max_zoom)) {
    throw UsageError("--zoom must be above 0 and at most 1e6");
  }
  if (!typed.inset.empty()) {
    const std::string complaint =
        "--inset needs x,y,factor: a point, 0 to 1 from the top left, and a factor above 0, at "
        "most 1e6";
    const std::vector<double> v = numbers(typed.inset, 3, ',', complaint);
    const auto is_share = [](double x) { return x >= 0 && x <= 1; };
    if (!(is_share(v[0]) && is_share(v[1]) && v[2] > 0 && v[2] <= max_zoom)) {
      throw UsageError(complaint);
    }
    render.inset = Inset{v[0], v[1], v[2]};
  }
  if (!typed.colour.empty()) render.colour = parsed_colour(typed.colour);
  if (typed.by == "angle") render.by = ColourBy::Angle;
  if (typed.by == "component") render.by = ColourBy::Component;
  if (typed.edges == "always") render.edges = DrawEdges::Always;
  if (typed.edges == "never") render.edges = DrawEdges::Never;
  render.shadows = !typed.no_shadows;
}

void finish(const FigureArguments& figure) {
  check_png(figure.output);
  if (figures::find_figure(figure.name) == nullptr) {
    throw UsageError("no figure " + figure.name);
  }
  if (!(figure.scale >= 0.1 && figure.scale <= 4)) {
    throw UsageError("--scale must be from 0.1 to 4");
  }
}

}  // namespace morskin::app
