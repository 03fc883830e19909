#include "app/batch/summary.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "app/report_lines.h"
#include "app/strict_json.h"

namespace morskin::app {
namespace {

using nlohmann::ordered_json;

struct Quantile {
  const char* name;
  double share;
};
constexpr Quantile quantiles[] = {{"least", 0},  {"5%", 0.05},  {"25%", 0.25}, {"median", 0.5},
                                  {"75%", 0.75}, {"95%", 0.95}, {"most", 1}};

/// The least value that so large a share of them does not exceed. @pre values are sorted, not empty
double quantile(const std::vector<double>& values, double share) {
  const double rank = std::ceil(share * static_cast<double>(values.size()));
  return values[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

}  // namespace

BatchSummary summarized(const std::vector<BatchInput>& inputs,
                        const std::map<std::string, BatchRow>& rows) {
  BatchSummary summary;
  summary.inputs = inputs.size();
  summary.values.resize(measures.size());
  for (const BatchInput& input : inputs) {
    const auto found = rows.find(input.name);
    if (found == rows.end()) continue;
    ++summary.rows;
    ++summary.by_status[found->second.status];
    for (std::size_t i = 0; i < measures.size(); ++i) {
      const double value = found->second.values[i];
      if (!std::isnan(value)) summary.values[i].push_back(value);
    }
  }
  for (std::vector<double>& values : summary.values) std::ranges::sort(values);
  return summary;
}

std::string json_text(const BatchSummary& summary) {
  ordered_json json = {{"inputs", summary.inputs},
                       {"rows", summary.rows},
                       {"made", summary.made},
                       {"run_seconds", rounded(summary.seconds)},
                       {"statuses", summary.by_status}};
  for (std::size_t i = 0; i < measures.size(); ++i) {
    const std::vector<double>& values = summary.values[i];
    if (values.empty()) continue;
    ordered_json& of_it = json[measures[i]];
    of_it["count"] = values.size();
    of_it["sum"] = sum(values);
    for (const auto& [name, share] : quantiles) of_it[name] = quantile(values, share);
  }
  return strict_json(json);
}

std::string people_text(const BatchSummary& summary) {
  std::string text = counted(summary.inputs, "molecule", "molecules") + ", " +
                     counted(summary.rows, "row", "rows") + ", " + grouped(summary.made) +
                     " made now in " + brief(summary.seconds, 3) + " s";
  std::string statuses;
  for (const auto& [status, count] : summary.by_status) {
    if (!statuses.empty()) statuses += ", ";
    statuses.append(grouped(count)).append(" ").append(status);
  }
  if (!statuses.empty()) text.append(": ").append(statuses);
  text += '\n';
  const auto is_empty = [](const std::vector<double>& values) { return values.empty(); };
  if (std::ranges::all_of(summary.values, is_empty)) return text;
  const auto table_line = [](const std::string& label, const std::vector<std::string>& cells) {
    std::string result(2, ' ');
    result += label;
    std::size_t width = 30;
    for (const std::string& cell : cells) {
      width += 11;
      result.resize(std::max(result.size() + 1, width - cell.size()), ' ');
      result += cell;
    }
    result += '\n';
    return result;
  };
  std::vector<std::string> cells;
  for (const Quantile& one : quantiles) cells.emplace_back(one.name);
  text += table_line("", cells);
  for (std::size_t i = 0; i < measures.size(); ++i) {
    if (summary.values[i].empty()) continue;
    cells.clear();
    for (const Quantile& one : quantiles) {
      cells.push_back(brief(quantile(summary.values[i], one.share)));
    }
    text += table_line(measures[i], cells);
  }
  return text;
}

}  // namespace morskin::app
