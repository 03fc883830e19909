#include "app/skin_parts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "app/report_lines.h"
#include "geometry/mesh_shape.h"
#include "morskin/bent_part.h"
#include "morskin/voids.h"
#include "skin/skin_components.h"

namespace morskin::app {
namespace {

using nlohmann::ordered_json;

/// About how many triangles a surface of such a demand, the integral of rho^-2, takes at least.
double forced_triangles(double demand) {
  const double largest = morskin::max_provable_share;  // circumradius over rho
  return demand / (0.75 * std::sqrt(3) * largest * largest);
}

double forced_triangles(const std::vector<skin::Waist>& waists) {
  double sum = 0;
  for (const skin::Waist& w : waists) sum += forced_triangles(w.demand);
  return sum;
}

ordered_json point_json(const geometry::Point& p) {
  return {rounded(p.x()), rounded(p.y()), rounded(p.z())};
}

/// Outwards where they are bounds; of a mesh both are its volume.
ordered_json volume_json(const skin::VolumeBounds& volume) {
  if (volume.low == volume.high) return {rounded(volume.low), rounded(volume.high)};
  return {rounded_lower_bound(volume.low), rounded_bound(volume.high)};
}

ordered_json waists_json(const std::vector<skin::Waist>& waists) {
  constexpr std::size_t most = 20;
  ordered_json narrowest = ordered_json::array();
  for (std::size_t i = 0; i < std::min(waists.size(), most); ++i) {
    narrowest.push_back({{"radius", rounded(waists[i].radius)},
                         {"at", point_json(waists[i].centre)},
                         {"forced_triangles", std::round(forced_triangles(waists[i].demand))}});
  }
  return {{"count", waists.size()},
          {"forced_triangles", std::round(forced_triangles(waists))},
          {"narrowest", std::move(narrowest)}};
}

/// " of 0.14 to 4.3 A^3", of those that are known.
std::string volumes_text(const std::vector<SkinParts::Cavity>& voids) {
  std::vector<double> known;
  for (const SkinParts::Cavity& v : voids) {
    if (v.volume) known.push_back(v.volume->middle());
  }
  if (known.empty()) return "";
  const std::string largest = known.size() == 1 ? "" : " to " + brief(known.front(), 3);
  return " of " + brief(known.back(), 3) + largest + " A^3";
}

std::string voids_text(const std::vector<SkinParts::Cavity>& voids, const std::string& area = "") {
  if (voids.empty()) return line("voids", "none");
  const auto dropped = static_cast<std::size_t>(
      std::ranges::count_if(voids, [](const auto& v) { return v.is_dropped; }));
  // A mesh tells no volumes of those that it lacks.
  const auto known = static_cast<std::size_t>(
      std::ranges::count_if(voids, [](const auto& v) { return v.volume.has_value(); }));
  const bool is_of_others = dropped > 0 && known > 0 && known < voids.size();
  const std::string others = known == 1 ? ", the other" : ", the others";
  return line("voids", grouped(voids.size()) + (is_of_others ? "" : volumes_text(voids)) +
                           (dropped == 0 ? "" : "; " + grouped(dropped) + " dropped") +
                           (is_of_others ? others + volumes_text(voids) : "") + area);
}

std::string waists_text(const char* label, const std::vector<skin::Waist>& waists) {
  if (waists.empty()) return line(label, "none");
  const bool is_one = waists.size() == 1;
  const auto forced = static_cast<std::size_t>(std::llround(forced_triangles(waists)));
  return line(
      label, grouped(waists.size()) + (is_one ? ", of radius " : ", the narrowest of radius ") +
                 brief(waists.front().radius, 3) + (is_one ? " A; it forces " : " A; they force ") +
                 counted(forced, "triangle", "triangles"));
}

SkinParts parts_without_volumes(const morskin::PreparedSkin& skin) {
  SkinParts parts;
  parts.outer_surfaces = skin.topology.outer_bodies.size();
  for (std::uint32_t i = 0; i < skin.topology.voids.size(); ++i) {
    const skin::Void& v = skin.topology.voids[i];
    parts.voids.push_back({v.centre, std::nullopt, v.bodies.size() - 1, skin.has_dropped(i)});
  }
  const skin::SkinComponents sides_at(skin.surface, skin.topology);
  for (const skin::Waist& w : skin::waists(skin.surface)) {
    const auto is_dropped = [&](const geometry::Point& x) {
      return morskin::is_on_dropped(skin, sides_at, skin.surface.at(x, w.cell));
    };
    if (std::ranges::all_of(w.on_skin, is_dropped)) continue;
    (w.is_tunnel ? parts.tunnels : parts.necks).push_back(w);
  }
  return parts;
}

/// The largest first, those without a volume last.
void sort_by_volume(std::vector<SkinParts::Cavity>& voids) {
  std::ranges::stable_sort(voids, std::greater(), [](const SkinParts::Cavity& v) {
    return v.volume ? v.volume->middle() : -1;
  });
}

/// Measures the mesh on the walls of voids.
void measure_walls(SkinParts& parts, const morskin::PreparedSkin& skin,
                   const morskin::MeshResult& result) {
  const std::vector<geometry::Point>& at = result.mesh.positions;
  const std::vector<std::uint32_t> component = geometry::vertex_components(result.mesh);
  const skin::SkinComponents sides_at(skin.surface, skin.topology);
  struct Wall {
    std::optional<std::uint32_t> cavity;  // whose wall it is
    geometry::Point apex;
    double volume = 0;  // Angstrom^3; negative, for it faces into the void
  };
  std::vector<Wall> walls;  // by component
  for (std::uint32_t v = 0; v < at.size(); ++v) {
    if (component[v] < walls.size()) continue;
    const auto sides = sides_at.sides(skin.surface.at(at[v], result.cells[v]));
    walls.push_back({sides ? sides->cavity : std::nullopt, at[v]});
  }
  for (const auto& [a, b, c] : result.mesh.triangles) {
    Wall& wall = walls[component[a]];
    if (!wall.cavity) continue;
    const geometry::Vector doubled = (at[b] - at[a]).cross(at[c] - at[a]);
    parts.void_area += doubled.norm() / 2;
    wall.volume += (at[a] - wall.apex).dot(doubled) / 6;
  }
  for (const Wall& wall : walls) {
    if (!wall.cavity) continue;
    auto& sum = parts.voids[*wall.cavity].volume;
    const double volume = (sum ? sum->low : 0) - wall.volume;
    sum = skin::VolumeBounds{volume, volume};
  }
}

}  // namespace

SkinParts skin_parts(const morskin::PreparedSkin& skin, const morskin::Run& run) {
  SkinParts parts = parts_without_volumes(skin);
  const std::vector<skin::VolumeBounds> volumes = morskin::void_volumes(skin, run);
  for (std::size_t i = 0; i < volumes.size(); ++i) parts.voids[i].volume = volumes[i];
  sort_by_volume(parts.voids);
  return parts;
}

SkinParts skin_parts(const morskin::PreparedSkin& skin, const morskin::MeshResult& result) {
  SkinParts parts = parts_without_volumes(skin);
  if (parts.voids.empty()) return parts;
  measure_walls(parts, skin, result);
  sort_by_volume(parts.voids);
  return parts;
}

void add_skin_parts(ordered_json& json, const SkinParts& parts) {
  json["voids"] = ordered_json::array();
  for (const SkinParts::Cavity& v : parts.voids) {
    ordered_json cavity = {
        {"at", point_json(v.at)}, {"bodies_inside", v.bodies_inside}, {"dropped", v.is_dropped}};
    if (v.volume) cavity["volume"] = volume_json(*v.volume);
    json["voids"].push_back(std::move(cavity));
  }
  json["necks"] = waists_json(parts.necks);
  json["tunnels"] = waists_json(parts.tunnels);
}

std::string waists_text(const SkinParts& parts) {
  return waists_text("necks", parts.necks) + waists_text("tunnels", parts.tunnels);
}

std::string skin_parts_text(const SkinParts& parts) {
  return voids_text(parts.voids) + waists_text(parts);
}

std::string surfaces_text(const SkinParts& parts, double area) {
  const std::string of_voids =
      parts.void_area == 0 ? "" : "; walls of " + brief(parts.void_area, 6) + " A^2";
  return line("outer", counted(parts.outer_surfaces, "surface", "surfaces") + " of " +
                           brief(area - parts.void_area, 6) + " A^2") +
         voids_text(parts.voids, of_voids);
}

}  // namespace morskin::app
