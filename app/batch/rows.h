#pragma once

/// What a batch says of its molecules: files of lines, each a JSON object.

#include <array>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/arguments.h"

namespace morskin::app {

/// Whether a text can stand in a row and be read again: UTF-8.
bool fits_in_row(const std::string& text);

/// Numbers in rows that are summed up; those of Angstrom and bytes as in the report of `mesh`.
inline constexpr std::array measures = {
    "atoms",         "vertices", "triangles",   "vertices_per_square_angstrom",
    "min_angle_deg", "seconds",  "cpu_seconds", "peak_memory_bytes"};

/// A row, as far as other runs need it.
struct BatchRow {
  std::string status;   ///< ok, refused, uncertified, unreadable, limit or failed
  std::string options;  ///< that decided what was made
  std::array<double, measures.size()> values;  ///< NaN where the row lacks one
};

/// `rows.jsonl`, with more shards than one `rows-I-of-N.jsonl`.
std::string rows_name(const Shard& shard);

/// The rows of a folder by their inputs, whatever shards wrote them. A last line without its end,
/// which a run writes at this moment or was killed at, is left out.
/// @throws geometry::UnreadableInput  for a line that is no row
std::map<std::string, BatchRow> read_rows(const std::filesystem::path& folder);

/// Cuts off torn last lines of a folder's files of rows, where no run writes them.
/// @throws geometry::UnwritableOutput  one has such a line and cannot be written
void cut_torn_lines(const std::filesystem::path& folder);

/// The file of one shard, locked.
class RowFile {
 public:
  /// Opens or makes the file and cuts off a torn last line.
  /// @throws geometry::UnwritableOutput  also where another run writes it
  explicit RowFile(std::filesystem::path path);
  RowFile(const RowFile&) = delete;
  RowFile& operator=(const RowFile&) = delete;
  ~RowFile();

  /// Adds a row, by one write of one line, and waits until it is on the disk.
  /// @throws geometry::UnwritableOutput  the file is then as it was, as far as it can be written
  void append(const nlohmann::ordered_json& row);

 private:
  void cut_torn_line();

  std::filesystem::path path_;
  int file_;
};

}  // namespace morskin::app
