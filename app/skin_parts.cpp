#include "app/skin_parts.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/report_lines.h"
#include "morskin/size_goal.h"
#include "morskin/voids.h"

namespace morskin::app {
namespace {

using nlohmann::ordered_json;

/// The fewest triangles that a surface of such a demand, the integral of rho^-2, can have.
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

std::string volumes_text(const std::vector<SkinParts::Cavity>& voids) {
  const double largest = voids.front().volume.middle(), smallest = voids.back().volume.middle();
  return brief(smallest, 3) + (voids.size() == 1 ? "" : " to " + brief(largest, 3)) + " A^3";
}

std::string voids_text(const std::vector<SkinParts::Cavity>& voids) {
  if (voids.empty()) return line("voids", "none");
  const auto dropped = static_cast<std::size_t>(
      std::ranges::count_if(voids, [](const auto& v) { return v.is_dropped; }));
  return line("voids", grouped(voids.size()) + " of " + volumes_text(voids) +
                           (dropped == 0 ? "" : "; " + grouped(dropped) + " dropped"));
}

std::string waists_text(const char* label, const std::vector<skin::Waist>& waists) {
  if (waists.empty()) return line(label, "none");
  return line(label, grouped(waists.size()) + ", the narrowest of radius " +
                         brief(waists.front().radius, 3) + " A; they force " +
                         grouped(std::llround(forced_triangles(waists))) + " triangles");
}

}  // namespace

SkinParts skin_parts(const morskin::PreparedSkin& skin, const morskin::Run& run) {
  SkinParts parts;
  const std::vector<skin::VolumeBounds> volumes = morskin::void_volumes(skin, run);
  for (std::uint32_t i = 0; i < volumes.size(); ++i) {
    const skin::Void& v = skin.topology.voids[i];
    parts.voids.push_back({v.centre, volumes[i], v.bodies.size() - 1, skin.has_dropped(i)});
  }
  std::ranges::stable_sort(parts.voids, std::greater(),
                           [](const SkinParts::Cavity& v) { return v.volume.middle(); });
  for (const skin::Waist& w : skin::waists(skin.surface)) {
    (w.is_tunnel ? parts.tunnels : parts.necks).push_back(w);
  }
  return parts;
}

void add_skin_parts(ordered_json& json, const SkinParts& parts) {
  json["voids"] = ordered_json::array();
  for (const SkinParts::Cavity& v : parts.voids) {
    json["voids"].push_back({{"volume", {rounded(v.volume.low), rounded(v.volume.high)}},
                             {"at", point_json(v.at)},
                             {"bodies_inside", v.bodies_inside},
                             {"dropped", v.is_dropped}});
  }
  json["necks"] = waists_json(parts.necks);
  json["tunnels"] = waists_json(parts.tunnels);
}

std::string skin_parts_text(const SkinParts& parts) {
  return voids_text(parts.voids) + waists_text("necks", parts.necks) +
         waists_text("tunnels", parts.tunnels);
}

}  // namespace morskin::app
