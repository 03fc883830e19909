// Where each format holds its provenance.

#include <algorithm>
#include <cstddef>

#include "geometry/files/mesh_formats.h"
#include "geometry/files/text_lines.h"

namespace morskin::geometry::mesh_formats {
namespace {

constexpr std::string_view mark = "morskin: ";
constexpr std::string_view separator = "; ";

// Far above what is ever written; files that hold more mean harm.
constexpr std::size_t max_entries = 64, max_entry = 1 << 14;

void take_comment(Provenance& provenance, std::string_view comment) {
  comment = trimmed(comment);
  if (!comment.starts_with(mark)) return;
  take_entry(provenance, comment.substr(mark.size()));
}

std::string joined(const Provenance::Entry& entry) { return entry.key + ' ' + entry.value; }

}  // namespace

void take_entry(Provenance& provenance, std::string_view text) {
  if (text.size() > max_entry || provenance.entries.size() >= max_entries) return;
  text = trimmed(text);
  const std::string_view key = take_field(text);
  if (!key.empty()) provenance.entries.push_back({std::string(key), std::string(trimmed(text))});
}

std::string provenance_lines(const Provenance& provenance, std::string_view start) {
  std::string text;
  for (const Provenance::Entry& entry : provenance.entries) {
    text += std::string(start) + std::string(mark) + joined(entry) + '\n';
  }
  return text;
}

std::string provenance_line(const Provenance& provenance) {
  std::string text;
  for (const Provenance::Entry& entry : provenance.entries) {
    text += std::string(text.empty() ? "" : separator) + joined(entry);
  }
  return text.empty() ? "" : "# " + std::string(mark) + text + '\n';
}

Provenance ply_provenance(std::string_view bytes) {
  Provenance provenance;
  TextLines lines(bytes, "");
  while (lines.advance()) {
    std::string_view line = lines.line();
    const std::string_view word = take_field(line);
    if (word == "end_header") break;
    if (word == "comment") take_comment(provenance, line);
  }
  return provenance;
}

Provenance msh_provenance(std::string_view bytes) {
  Provenance provenance;
  TextLines lines(bytes, "");
  while (lines.advance() && trimmed(lines.line()) != "$EndComments") {
    take_comment(provenance, lines.line());
  }
  return provenance;
}

Provenance obj_provenance(std::string_view bytes) {
  Provenance provenance;
  TextLines lines(bytes, "");
  while (lines.advance() && lines.line().starts_with('#')) {
    take_comment(provenance, lines.line().substr(1));
  }
  return provenance;
}

Provenance off_provenance(std::string_view bytes) {
  // From the end back to the first comment of the last block.
  std::size_t start = bytes.size();
  while (start > 0) {
    const std::size_t line = bytes.find_last_of('\n', start < 2 ? 0 : start - 2) + 1;
    if (line >= start || bytes[line] != '#') break;
    start = line;
  }
  return obj_provenance(bytes.substr(start));
}

Provenance msms_provenance(std::string_view bytes) {
  Provenance provenance;
  TextLines lines(bytes, "");
  if (!lines.advance() || !lines.line().starts_with('#')) return provenance;
  std::string_view text = trimmed(lines.line().substr(1));
  if (!text.starts_with(mark)) return provenance;
  text.remove_prefix(mark.size());
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    take_entry(provenance, text.substr(0, end));
    text.remove_prefix(std::min(end + separator.size(), text.size()));
  }
  return provenance;
}

Provenance stl_provenance(std::string_view bytes) {
  Provenance provenance;
  if (!looks_like_binary_stl(bytes) || !bytes.starts_with("morskin ")) return provenance;
  const std::string_view header = bytes.substr(0, Provenance::max_brief);
  provenance.brief = header.substr(0, header.find('\0'));
  return provenance;
}

}  // namespace morskin::geometry::mesh_formats
