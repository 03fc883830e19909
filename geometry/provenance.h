#pragma once

/// What a mesh file says of its own origin.

#include <string>
#include <vector>

namespace morskin::geometry {

/// Keys with values, which mean nothing to the file formats.
///
/// PLY and OBJ hold them as comments `morskin: key value` before the mesh, OFF behind it, where all
/// its readers have stopped; MSMS's files in one comment, their first line, with semicolons
/// between; MSH as lines of its section of comments; VTU as field data, GLB and NPZ as JSON; binary
/// STL has space for the brief text only. Of a file only the first 64 entries are read, and none of
/// more than 16 KiB.
struct Provenance {
  struct Entry {
    std::string key;    ///< letters, digits, `-` and `_`
    std::string value;  ///< printable ASCII without semicolons, backslashes or blanks at its ends
    bool is_number = false;
    bool operator==(const Entry&) const = default;
  };
  static constexpr std::size_t max_brief = 80;

  std::vector<Entry> entries;  ///< each key once where they are written, but files may repeat some
  std::string brief;           ///< at most max_brief characters, begins with "morskin "

  bool is_empty() const { return entries.empty() && brief.empty(); }
};

}  // namespace morskin::geometry
