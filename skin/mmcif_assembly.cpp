// Biological assemblies in mmCIF, of operators that expressions like "(X0)(1-60)" combine.

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "geometry/error.h"
#include "geometry/files/text_lines.h"
#include "skin/assembly.h"

namespace morskin::skin::molecule_formats {
namespace {

using geometry::quoted;
using geometry::RefusedInput;
using geometry::trimmed;
using geometry::UnreadableInput;

std::vector<std::string_view> split(std::string_view list) {
  std::vector<std::string_view> parts;
  for (std::size_t first = 0; first <= list.size();) {
    const std::size_t comma = std::min(list.find(',', first), list.size());
    parts.push_back(trimmed(list.substr(first, comma - first)));
    first = comma + 1;
  }
  return parts;
}

/// "1-60".
struct Range {
  std::int64_t first, last;
};
std::optional<Range> range_of(std::string_view text) {
  const std::size_t hyphen = text.find('-');
  if (hyphen == std::string_view::npos) return std::nullopt;
  const auto first = geometry::parse_integer(text.substr(0, hyphen));
  const auto last = geometry::parse_integer(text.substr(hyphen + 1));
  if (!first || !last || *first < 0 || *last < *first) return std::nullopt;
  return Range{*first, *last};
}

/// The motion that does `second`, then `first`, as expressions write it.
Motion composed(const Motion& first, const Motion& second) {
  return {first.name + " " + second.name, first.rotation * second.rotation,
          first.rotation * second.translation + first.translation};
}

/// The operators of a file by their ids, and what expressions make of them.
class Operators {
 public:
  Operators(const AssemblyTables& tables, const std::string& source) : source_(source) {
    for (const AssemblyTables::Operator& row : tables.operators) {
      Motion motion{row.id, {}, {}};
      for (std::size_t i = 0; i < row.numbers.size(); ++i) {
        const std::optional<double> number = geometry::parse_double(row.numbers[i]);
        if (!number) {
          throw UnreadableInput(source + ": operator " + quoted(row.id) + " has " +
                                quoted(row.numbers[i]) + " in its matrix or vector; correct it");
        }
        const auto k = static_cast<Eigen::Index>(i);
        (i < 9 ? motion.rotation(k / 3, k % 3) : motion.translation[k - 9]) = *number;
      }
      if (!by_id_.emplace(row.id, motion).second) {
        throw UnreadableInput(source + ": has two operators " + quoted(row.id) + "; remove one");
      }
    }
  }

  /// Of "1,2,5-9", or of "(1-60)(P)", where each of the first list follows each of the second.
  std::vector<Motion> motions(std::string_view expression) const {
    const std::string_view all = expression;
    std::vector<std::vector<Motion>> factors;
    std::size_t count = 1;  // of copies, asked before there is memory for them
    while (!(expression = trimmed(expression)).empty()) {
      const bool is_open = expression.front() == '(';
      const std::size_t end = expression.find(is_open ? ')' : '(');
      if (is_open && end == std::string_view::npos) fail(all, "lacks a closing bracket");
      factors.push_back(listed(expression.substr(is_open, end - is_open), all));
      check_count(count *= factors.back().size(), all);
      expression.remove_prefix(std::min(end, expression.size() - is_open) + is_open);
    }
    if (factors.empty()) fail(all, "is empty");
    std::vector<Motion> product = factors.front();
    for (std::size_t i = 1; i < factors.size(); ++i) {
      std::vector<Motion> next;
      for (const Motion& first : product) {
        for (const Motion& second : factors[i]) next.push_back(composed(first, second));
      }
      product = std::move(next);
    }
    return product;
  }

  /// @param all  the expression that comes to so many copies, with those before it
  void check_count(std::size_t count, std::string_view all) const {
    if (count <= max_motions) return;
    throw RefusedInput(source_ + ": the operators " + quoted(all) +
                       " make more than 100,000 copies; take another assembly");
  }

 private:
  std::vector<Motion> listed(std::string_view list, std::string_view all) const {
    std::vector<Motion> motions;
    for (const std::string_view item : split(list)) {
      if (by_id_.contains(item)) {
        motions.push_back(checked(item, all));
      } else if (const std::optional<Range> range = range_of(item)) {
        // The first number that is no operator ends it, so a range is no longer than their table.
        for (std::int64_t id = range->first;; ++id) {
          motions.push_back(checked(std::to_string(id), all));
          if (id == range->last) break;
        }
      } else {
        fail(all, "names an operator " + quoted(item) + " that the file does not have");
      }
      check_count(motions.size(), all);
    }
    return motions;
  }

  const Motion& checked(std::string_view id, std::string_view all) const {
    const auto found = by_id_.find(id);
    if (found == by_id_.end()) {
      fail(all, "names an operator " + quoted(id) + " that the file does not have");
    }
    check_motion(found->second, source_);
    return found->second;
  }

  [[noreturn]] void fail(std::string_view expression, const std::string& what) const {
    throw UnreadableInput(source_ + ": the expression of operators " + quoted(expression) + " " +
                          what + "; correct it");
  }

  const std::string& source_;
  std::map<std::string, Motion, std::less<>> by_id_;
};

}  // namespace

Assembly mmcif_assembly(std::string_view bytes, const std::string& source,
                        const std::string& name) {
  const AssemblyTables tables = assembly_tables(bytes, source);
  const Operators operators(tables, source);
  Assembly assembly{name, {}};
  std::vector<std::string> known;  // in the file's order
  std::set<std::string> seen;
  std::size_t copies = 0;  // of all parts
  for (const AssemblyTables::Generator& row : tables.generators) {
    if (seen.insert(row.assembly).second) known.push_back(row.assembly);
    if (row.assembly != name) continue;
    AssemblyPart& part = assembly.parts.emplace_back();
    for (const std::string_view chain : split(row.chains)) part.chains.insert(Label(chain));
    part.motions = operators.motions(row.expression);
    copies += part.motions.size();
    operators.check_count(copies, row.expression);
  }
  if (assembly.parts.empty()) refuse_assembly(source, name, known);
  return assembly;
}

}  // namespace morskin::skin::molecule_formats
