#include "app/mesh_origin.h"

#include "app/percent_encoding.h"
#include "app/version.h"
#include "geometry/files/text_lines.h"

namespace morskin::app {
namespace {

using geometry::Provenance;
using Entries = std::vector<Provenance::Entry>;

void add(Entries& entries, std::string key, double number) {
  std::string value;
  geometry::append_number(value, number);
  entries.push_back({std::move(key), std::move(value), true});
}

void add(Entries& entries, std::string key, const std::optional<std::string>& text) {
  if (text) entries.push_back({std::move(key), percent_encoded(*text, ","), false});
}

void add_selection(Entries& entries, const TypedSelection& typed) {
  add(entries, "model-number", typed.model_number);
  add(entries, "chain", typed.chains);
  if (typed.waters) add(entries, "waters", std::string("keep"));
  add(entries, "hetatm", typed.hetatms);
  add(entries, "altloc", typed.locations);
  add(entries, "hydrogens", typed.hydrogens);
  add(entries, "biological-assembly", typed.assembly);
}

// All that fits into the 80 bytes of STL.
std::string brief(std::string_view verdict, const std::string& input_sha256,
                  const std::string& corners_sha256) {
  constexpr std::size_t digits = 8;
  static_assert(version.size() <= 7);
  return "morskin " + std::string(version) + ", A, " + std::string(verdict) + ", input " +
         input_sha256.substr(0, digits) + ", corners " + corners_sha256.substr(0, digits);
}

}  // namespace

MeshOrigin::MeshOrigin(const MeshArguments& arguments, const MoleculeInput& input)
    : arguments_(arguments),
      sizing_(arguments.sizing),
      input_sha256_(input.sha256),
      radii_(input.molecule.radii) {}

void MeshOrigin::add_molecule(Entries& entries) const {
  const MoleculeArguments& molecule = arguments_.molecule;
  add(entries, "input", molecule.input.filename().string());
  add(entries, "input-sha256", input_sha256_);
  add(entries, "radii", radii_);
  add(entries, "model", std::string(skin::name_of(molecule.model)));
  if (skin::has_probe(molecule.model)) add(entries, "probe", molecule.probe);
  add_selection(entries, arguments_.typed.selection);
  add(entries, "voids", arguments_.typed.voids.value_or("keep"));
  if (arguments_.grow_to != 0) add(entries, "grow", arguments_.grow_to);
}

Provenance MeshOrigin::provenance(const MeshHashes& hashes, std::string_view verdict) const {
  Provenance result;
  result.brief = brief(verdict, input_sha256_, hashes.coordinates);
  Entries& entries = result.entries;
  add(entries, "version", std::string(version));
  if (arguments_.surface) {
    // As it was typed, as far as a line takes it.
    entries.push_back({"surface", percent_encoded(*arguments_.surface, ",:=()+*/^"), false});
    add(entries, "input-sha256", input_sha256_);
  } else {
    add_molecule(entries);
  }
  add(entries, "C", sizing_.C);
  add(entries, "Q", sizing_.Q);
  if (arguments_.typed.size) {
    add(entries, "size", *arguments_.typed.size);
  } else if (std::isfinite(sizing_.largest_length_scale)) {
    add(entries, "size", sizing_.edge_length());
  }
  add(entries, "coordinates-sha256", hashes.coordinates);
  if (!hashes.faces.empty()) add(entries, "faces-sha256", hashes.faces);
  entries.push_back({"verdict", std::string(verdict)});
  return result;
}

}  // namespace morskin::app
