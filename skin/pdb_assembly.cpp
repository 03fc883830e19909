// Biological assemblies in REMARK 350 of PDB.

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/error.h"
#include "geometry/files/text_lines.h"
#include "skin/assembly.h"

namespace morskin::skin::molecule_formats {
namespace {

using geometry::parse_double;
using geometry::TextLines;
using geometry::trimmed;

constexpr std::string_view remark = "REMARK 350";
constexpr std::size_t text_end = 72;  // old files have the entry's code and a number behind it

/// "A, B, C,"; some programs leave the commas out.
std::vector<std::string> names_in(std::string_view text) {
  std::string words(text);
  std::ranges::replace(words, ',', ' ');
  const std::vector<std::string_view> fields = geometry::fields_of(words);
  return {fields.begin(), fields.end()};
}

/// Goes through the remark line by line and keeps one assembly.
class Reader {
 public:
  Reader(std::string_view bytes, const std::string& source, const std::string& name)
      : lines_(bytes, source), wanted_{name, {}} {}

  Assembly read() {
    while (lines_.advance()) {
      const std::string_view line = lines_.line();
      if (line.starts_with("ATOM") || line.starts_with("HETATM")) break;
      if (line.starts_with(remark)) take(trimmed(line.substr(0, text_end).substr(remark.size())));
    }
    finish_motion();
    if (wanted_.parts.empty()) refuse_assembly(lines_.source(), wanted_.name, known_);
    return std::move(wanted_);
  }

 private:
  void take(std::string_view text) {
    const auto skip = [&](std::string_view words) {
      if (!text.starts_with(words)) return false;
      text = trimmed(text.substr(words.size()));
      return true;
    };
    if (skip("BIOMOLECULE:")) {
      finish_motion();
      begin(names_in(text));
    } else if (skip("APPLY THE FOLLOWING TO CHAINS:") ||
               skip("IN ADDITION APPLY THE FOLLOWING TO CHAINS:")) {  // older files
      finish_motion();
      if (known_.empty()) begin({"1"});  // the only one needs no name
      if (is_wanted_) wanted_.parts.emplace_back();
      add_chains(text);
    } else if (skip("AND CHAINS:")) {
      add_chains(text);
    } else if (is_wanted_ && text.starts_with("BIOMT")) {
      take_row(text);
    }
  }

  void begin(const std::vector<std::string>& names) {
    is_wanted_ = std::ranges::find(names, wanted_.name) != names.end();
    known_.insert(known_.end(), names.begin(), names.end());
  }

  void add_chains(std::string_view text) {
    if (!is_wanted_ || wanted_.parts.empty()) return;
    for (const std::string& name : names_in(text)) {
      wanted_.parts.back().chains.insert(name == "NULL" ? Label() : Label(name));
    }
  }

  /// "BIOMT2   7  0.5 -0.3 0.8  12.0", row 2 of motion 7.
  void take_row(std::string_view text) {
    const std::vector<std::string_view> fields = geometry::fields_of(text);
    if (wanted_.parts.empty()) {
      lines_.fail("has a matrix before any chains to apply it to; correct it");
    }
    if (rows_ == 3) finish_motion();
    if (fields.size() != 6 || fields[0] != "BIOMT" + std::to_string(rows_ + 1) ||
        (rows_ > 0 && fields[1] != motion_.name)) {
      lines_.fail("is no row " + std::to_string(rows_ + 1) + " of a matrix; correct it");
    }
    motion_.name = fields[1];
    for (Eigen::Index column = 0; column < 4; ++column) {
      const std::optional<double> number =
          parse_double(fields[static_cast<std::size_t>(column + 2)]);
      if (!number) lines_.fail("has a number of a matrix that is none; correct it");
      (column < 3 ? motion_.rotation(rows_, column) : motion_.translation[rows_]) = *number;
    }
    if (++rows_ == 3) check_motion(motion_, lines_.location());
  }

  void finish_motion() {
    if (rows_ == 0) return;
    if (rows_ < 3) {
      throw geometry::UnreadableInput(lines_.location() + ": the matrix " +
                                      geometry::quoted(motion_.name) +
                                      " before has fewer than three rows; complete it");
    }
    std::vector<Motion>& motions = wanted_.parts.back().motions;
    // Numbers begin anew for other chains, with other matrices.
    motion_.name = name_of(motion_);
    motions.push_back(std::exchange(motion_, {}));
    rows_ = 0;
    if (++motion_count_ > max_motions) {
      throw geometry::RefusedInput(lines_.location() +
                                   ": has more than 100,000 matrices; remove some");
    }
  }

  /// By its numbers, so that one motion has one name.
  static std::string name_of(const Motion& motion) {
    std::string name;
    for (const double number : motion.rotation.reshaped()) {
      geometry::append_number(name, number + 0.0);  // -0 is 0
      name += ' ';
    }
    for (const double number : motion.translation) {
      geometry::append_number(name, number + 0.0);
      name += ' ';
    }
    return name;
  }

  TextLines lines_;
  Assembly wanted_;
  std::vector<std::string> known_;
  bool is_wanted_ = false;        // what is being read
  std::size_t motion_count_ = 0;  // of all parts
  Motion motion_;
  Eigen::Index rows_ = 0;  // of the motion that have come
};

}  // namespace

Assembly pdb_assembly(std::string_view bytes, const std::string& source, const std::string& name) {
  return Reader(bytes, source, name).read();
}

}  // namespace morskin::skin::molecule_formats
