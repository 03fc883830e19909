#pragma once

/// Skins, their meshes and their Morse theory as things to be drawn.

#include "app/figures/panels.h"
#include "morse/morse_smale_complex.h"
#include "morskin/pipeline.h"

namespace morskin::figures {

/// The mesh of a skin with the skin's own normals.
MeshLayer skin_layer(const morskin::PreparedSkin& skin, const morskin::MeshResult& result);
/// A partial mesh: its first triangles.
MeshLayer skin_layer(const surface::Mesh& mesh, std::size_t triangles);
/// The same moved inwards by a share of the length scale, so that a coarser mesh stands before it.
MeshLayer backdrop(const morskin::PreparedSkin& skin, const morse::MorseFunction& function,
                   double inwards);

/// @param C, function  as in morskin::MeshingOptions
morskin::MeshResult meshed(const morskin::PreparedSkin& skin, double C,
                           const std::optional<morse::MorseFunction>& function = {});

/// A ball at each critical point in the colour of its kind, mostly outside the surface.
void add_critical_points(Scene& scene, std::span<const morse::CriticalPoint> points, double radius);

/// A level curve of a function on a mesh, as segments.
/// @param lift  pictures::Line::lift
void add_level_curve(Scene& scene, const MeshLayer& layer, const morse::MorseFunction& function,
                     double value, const Colour& colour, double width, double lift);

/// A camera along the shortest principal axis of some points, the longest upright.
Camera principal_camera(std::span<const Point> points, int width, int height);

}  // namespace morskin::figures
