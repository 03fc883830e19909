#include "skin/assembly.h"

#include <Eigen/LU>
#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "geometry/error.h"
#include "geometry/files/text_lines.h"

namespace morskin::skin::molecule_formats {
namespace {

using geometry::RefusedInput;

/// The mark between a chain's name and the number of its copy, which no chain's name has.
char mark_for(const std::vector<AtomRecord>& atoms, const std::string& source) {
  for (const char mark : {'-', '_', '.', '+'}) {
    if (std::ranges::none_of(atoms, [&](const AtomRecord& record) {
          return record.atom.chain.view().find(mark) != std::string_view::npos;
        })) {
      return mark;
    }
  }
  throw RefusedInput(source + ": names of chains have all of - _ . +, so copies cannot be named; " +
                     "rename the chains");
}

Label copy_name(const Label& chain, char mark, std::size_t number, const std::string& source) {
  if (number == 1) return chain;
  const std::string name = std::string(chain.view()) + mark + std::to_string(number);
  const Label label(name);
  if (label.view() == name) return label;
  throw RefusedInput(source + ": copy " + std::to_string(number) + " of chain " +
                     std::string(chain.view()) + " would have a name of more than 8 characters; " +
                     "give the chain a shorter name");
}

/// By chain, the places of its atoms.
using Chains = std::map<Label, std::vector<std::size_t>>;

/// A motion, the number of its kind, and the chains that it copies.
struct Copy {
  const Motion* motion;
  std::size_t number;  ///< from 1, in the order of the assembly
  std::vector<Label> chains;
};

/// Those of an assembly.
struct Copies {
  std::vector<Copy> copies;
  std::size_t atoms = 0;  ///< of all
};

/// A chain that two parts give one motion is copied once. A file may name far more chains than it
/// has, or one motion very often: those are left out before they are copied.
/// @throws RefusedInput  they have more than `max_atoms`
Copies copies_of(const Assembly& assembly, const Chains& atoms_of, const std::string& source,
                 std::size_t max_atoms) {
  Copies result;
  std::map<std::string, std::pair<std::size_t, std::set<Label>>> known;
  for (const AssemblyPart& part : assembly.parts) {
    std::vector<Chains::const_iterator> present;
    for (const Label& chain : part.chains) {
      const auto found = atoms_of.find(chain);
      if (found != atoms_of.end()) present.push_back(found);
    }
    std::set<std::string_view> moved;  // motions that have copied all chains of the part
    for (const Motion& motion : part.motions) {
      if (!moved.insert(motion.name).second) continue;
      auto& [number, copied] =
          known.try_emplace(motion.name, known.size() + 1, std::set<Label>()).first->second;
      Copy copy{&motion, number, {}};
      for (const auto& chain : present) {
        if (!copied.insert(chain->first).second) continue;
        copy.chains.push_back(chain->first);
        result.atoms += chain->second.size();
      }
      if (result.atoms > max_atoms) {
        throw RefusedInput(source + ": biological assembly " + geometry::quoted(assembly.name) +
                           " has more than " + std::to_string(max_atoms) +
                           " atoms; leave more out");
      }
      result.copies.push_back(std::move(copy));
    }
  }
  return result;
}

}  // namespace

void check_motion(const Motion& motion, const std::string& location) {
  constexpr double tolerance = 1e-3;  // of a matrix in six decimals, or of one in three
  const Eigen::Matrix3d& r = motion.rotation;
  const double error = (r.transpose() * r - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  const bool is_finite = r.allFinite() && motion.translation.allFinite();
  if (is_finite && error <= tolerance && r.determinant() > 0) return;
  std::string why = "it has a number that is not finite";
  if (is_finite) {
    why = "its determinant is ";
    geometry::append_number(why, r.determinant());
  }
  throw RefusedInput(location + ": the motion " + geometry::quoted(motion.name) +
                     " of a biological assembly is no rotation with a shift, " + why +
                     "; correct it");
}

void refuse_assembly(const std::string& source, const std::string& name,
                     const std::vector<std::string>& others) {
  if (others.empty()) {
    throw RefusedInput(source + ": tells of no biological assembly; read it without one");
  }
  constexpr std::size_t max_names = 60;
  std::string names;
  for (std::size_t i = 0; i < std::min(others.size(), max_names); ++i) {
    names += (names.empty() ? "" : ", ") + others[i];
  }
  if (others.size() > max_names) names += " and more";
  throw RefusedInput(source + ": has no biological assembly " + geometry::quoted(name) +
                     "; choose from " + names);
}

std::size_t assemble(std::vector<AtomRecord>& atoms, const Assembly& assembly,
                     const std::string& source, std::size_t max_atoms) {
  Chains atoms_of;
  for (std::size_t i = 0; i < atoms.size(); ++i) atoms_of[atoms[i].assembly_chain].push_back(i);
  const auto [copies, count] = copies_of(assembly, atoms_of, source, max_atoms);
  if (count == 0) {
    throw RefusedInput(source + ": biological assembly " + geometry::quoted(assembly.name) +
                       " has none of the atoms that are selected; leave less out");
  }
  const char mark = copies.size() > 1 ? mark_for(atoms, source) : '-';
  std::vector<AtomRecord> result;
  result.reserve(count);
  std::set<Label> used;
  for (const Copy& copy : copies) {
    std::vector<std::size_t> indices;
    for (const Label& chain : copy.chains) {
      const std::vector<std::size_t>& of_chain = atoms_of.at(chain);
      indices.insert(indices.end(), of_chain.begin(), of_chain.end());
      used.insert(chain);
    }
    std::ranges::sort(indices);
    for (const std::size_t i : indices) {
      AtomRecord& copied = result.emplace_back(atoms[i]);
      Atom& atom = copied.atom;
      atom.position = copy.motion->rotation * atom.position + copy.motion->translation;
      atom.chain = copy_name(atom.chain, mark, copy.number, source);
    }
  }
  const auto left_out = static_cast<std::size_t>(std::ranges::count_if(
      atoms, [&](const AtomRecord& record) { return !used.contains(record.assembly_chain); }));
  atoms = std::move(result);
  return left_out;
}

}  // namespace morskin::skin::molecule_formats
