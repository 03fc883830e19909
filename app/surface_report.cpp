#include "app/surface_report.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/function_argument.h"
#include "app/report.h"
#include "app/strict_json.h"
#include "geometry/files/provenance_json.h"

namespace morskin::app {

using nlohmann::ordered_json;

SurfaceFacts SurfaceFacts::of(const implicit::PreparedSurface& prepared) {
  return {prepared.surface.cover().boxes.size(), prepared.surface.hessian_bound(),
          prepared.surface.max_length_scale(), prepared.critical.undecided.size(),
          prepared.critical.counts()};
}

std::optional<double> searched_within(const std::string& surface,
                                      const implicit::PreparedSurface& prepared) {
  if (!surface.starts_with("formula:")) return std::nullopt;
  return prepared.searched.half;
}

std::string searched_text(const std::optional<double>& within) {
  if (!within) return "";
  return line("searched", "where |x|, |y|, |z| <= " + brief(*within) +
                              "; what is zero beyond is left out (within=)");
}

std::string json_text(const SurfaceReport& report) {
  ordered_json json = {{"surface", report.surface},
                       {"C", report.sizing.C},
                       {"Q", report.sizing.Q},
                       {"cover_boxes", report.facts.boxes},
                       {"second_derivative_bound", rounded_bound(report.facts.hessian_bound)},
                       {"max_length_scale", rounded(report.facts.max_length_scale)},
                       {"undecided_boxes", report.facts.undecided}};
  if (report.within) json["within"] = *report.within;
  if (std::isfinite(report.sizing.largest_length_scale)) {
    json["edge_length"] = rounded(report.sizing.edge_length());
  }
  json.update(critical_json(report.facts.critical));
  json.update(certificate_json(report.certificate));
  if (!report.certificate.certified) json["reason"] = about_surface(report.certificate.reason);
  json["quality"] = quality_json(report.quality, report.certificate.area);
  json["certified_file"] = report.certified_file;
  json["outputs"] = ordered_json::array();
  for (const std::filesystem::path& output : report.outputs) {
    json["outputs"].push_back(output.string());
  }
  json["provenance"] = geometry::provenance_json(report.provenance);
  json["open_edges"] = report.counts.open_edges;
  json["seconds"] = {{"prepare", rounded(report.prepare_seconds)},
                     {"mesh", rounded(report.mesh_seconds)},
                     {"certify", rounded(report.certify_seconds)},
                     {"total", rounded(report.total_seconds)}};
  return strict_json(json);
}

std::string about_surface(std::string text) {
  constexpr std::string_view skin = "the skin", surface = "the surface";
  for (std::size_t at = 0; (at = text.find(skin, at)) != std::string::npos;) {
    text.replace(at, skin.size(), surface);
  }
  return text;
}

std::string people_text(const SurfaceReport& report) {
  std::string outputs;
  for (const std::filesystem::path& output : report.outputs) {
    outputs += (outputs.empty() ? "" : ", ") + output.string();
  }
  const SurfaceFacts& facts = report.facts;
  std::string text = report.surface + " -> " + (outputs.empty() ? "-" : outputs) + "\n";
  text +=
      line("surface", counted(facts.boxes, "box covers", "boxes cover") +
                          " it; second derivatives up to " + brief_bound(facts.hessian_bound, 4) +
                          ", length scales up to " + brief(facts.max_length_scale) + "; C " +
                          brief(report.sizing.C) + ", Q " + brief(report.sizing.Q));
  text += searched_text(report.within);
  text += line("function", in_words(report.counts.function));
  text += line("critical", critical_text(facts.critical) +
                               (facts.undecided == 0
                                    ? ", all of them, proved"
                                    : "; undecided " + counted(facts.undecided, "box", "boxes")));
  text += measures_text(report.certificate, report.sizing) +
          about_surface(certificate_text(report.certificate, critical_points_say));
  text += quality_text(report.quality, report.certificate.area);
  text += line("time", brief(report.total_seconds, 3) + " s: prepare " +
                           brief(report.prepare_seconds, 2) + ", mesh " +
                           brief(report.mesh_seconds, 2) + ", certify " +
                           brief(report.certify_seconds, 2));
  text += report.certificate.certified
              ? "certified: homeomorphic to the surface (" + report.certified_file + " read back)\n"
              : "NOT certified: " + about_surface(report.certificate.reason) + "\n";
  return text;
}

}  // namespace morskin::app
