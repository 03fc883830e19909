#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "app/batch/inputs.h"
#include "app/batch/rows.h"

namespace morskin::app {

/// What the rows of some molecules say together.
struct BatchSummary {
  std::size_t inputs = 0;
  std::size_t rows = 0;  ///< of those inputs, each counted once
  std::size_t made = 0;  ///< by this run
  double seconds = 0;    ///< of this run
  std::map<std::string, std::size_t> by_status;
  std::vector<std::vector<double>> values;  ///< by measure, sorted, without NaN
};

BatchSummary summarized(const std::vector<BatchInput>& inputs,
                        const std::map<std::string, BatchRow>& rows);

/// As strict_json writes it; quantiles are those of what has the figure.
std::string json_text(const BatchSummary& summary);
/// A line of counts and, where there are figures, a table of their quantiles.
std::string people_text(const BatchSummary& summary);

}  // namespace morskin::app
