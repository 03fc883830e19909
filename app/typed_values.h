#pragma once

/// Values of options that are numbers or words.

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/arguments.h"

namespace morskin::app {

/// The number that digits alone spell.
std::optional<std::int64_t> parse_digits(std::string_view text);

/// Of --max-memory: "1500000", "200K", "1.5G"; K, M, G and T are powers of 1024.
/// @throws UsageError
std::uint64_t parsed_bytes(std::string_view text);

/// Of --progress: auto, always or never.
ShowProgress parsed_progress(std::string_view word);

/// Of --voids: keep, drop or a volume, Angstrom^3. Voids below the result are dropped.
/// @throws UsageError
double parsed_voids(std::string_view text);

/// Of --grow: T0..T1, the earlier first.
/// @throws UsageError
std::pair<double, double> parsed_growth(std::string_view text);

/// Of --snapshot-at, given as often as there are lists: finite numbers with commas between.
/// @throws UsageError
std::vector<double> parsed_snapshots_at(const std::vector<std::string>& lists);

/// Of --vertex-data: names of groups with commas between them, or all.
/// @throws UsageError
VertexData parsed_vertex_data(std::string_view text);

}  // namespace morskin::app
