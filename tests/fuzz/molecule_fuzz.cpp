// Any bytes as a molecule of any format: read, or turned down with a reason; never anything else,
// and what is read keeps the reader's law. The first byte chooses the ending and the selection.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "geometry/error.h"
#include "skin/molecule_files.h"
#include "tests/fuzz/endings.h"
#include "tests/fuzz/require.h"

using namespace morskin;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr double most = 1e6;  // Angstrom; the law of read_molecule
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  skin::ReadOptions options;
  options.selection.waters = (data[0] & 64) != 0;
  if ((data[0] & 128) != 0) {
    options.selection.hetatms.emplace();
    options.selection.location = 'B';
    options.selection.hydrogens = false;
  }
  try {
    const auto molecule = skin::parse_molecule(bytes, fuzz::molecule_name(data[0]), options);
    fuzz::require(!molecule.atoms.empty());
    for (const skin::Atom& atom : molecule.atoms) {
      fuzz::require(atom.position.allFinite() && atom.position.cwiseAbs().maxCoeff() <= most);
      fuzz::require(atom.radius > 0 && atom.radius <= most);
    }
  } catch (const geometry::UnreadableInput&) {
  } catch (const geometry::RefusedInput&) {
  }
  return 0;
}
