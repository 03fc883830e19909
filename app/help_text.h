#pragma once

/// What `morskin --help` says before and after its list of commands.

namespace morskin::app {

inline constexpr const char* about =
    "morskin writes a triangle mesh of a molecule's skin surface that is proved homeomorphic to "
    "the\n"
    "surface, has no angle below 30 degrees, and can be checked again from the written file.\n"
    "Homeomorphic: it has the surface's pieces, tunnels and voids, each once, and no others.\n"
    "\n"
    "INPUT is PDB, mmCIF, PQR, XYZ, XYZR (x y z r) or XYZW (x y z w, w the weight), each also\n"
    "gzipped; \"-\" is standard input. Lengths are in Angstrom, angles in degrees. Unless options "
    "say\n"
    "otherwise the first model is read, of alternate locations the likeliest, and no water.\n";

inline constexpr const char* closing =
    "Models (r: the atom's van der Waals radius, p: the probe's, W: weight of the ball; the\n"
    "atom's sphere patch has the radius sqrt(W/2)):\n"
    "  paper     W = sqrt(2) (r + p), as the paper prints it\n"
    "  sas       W = 2 (r + p)^2     patches have the solvent-accessible radius\n"
    "  vdw       W = 2 r^2           patches have the radius r; p plays no part (default)\n"
    "  ses-like  W = 2 (r + 0.25)^2  the skin nearest to a solvent-excluded surface\n"
    "  given     W as in the file, of XYZW only\n"
    "\n"
    "Examples:\n"
    "  morskin 1crn.pdb -o 1crn.ply            the same as morskin mesh 1crn.pdb ...\n"
    "  morskin 1crn.pdb                        the same as morskin info 1crn.pdb\n"
    "  morskin mesh 1crn.cif.gz -o 1crn.ply -o 1crn.vtu --model sas --report 1crn.json\n"
    "  morskin check 1crn.ply --against 1crn.pdb\n"
    "  morskin morse 1crn.pdb -o 1crn.json --function distance:9,9,7\n"
    "  morskin info 1crn.pdb --json\n"
    "  morskin view 1crn.pdb -o 1crn.html\n"
    "\n"
    "Exit codes:\n"
    "  0  meshed and certified           5  not certified: see OUT.unverified\n"
    "  2  wrong arguments                6  a limit of memory or time was reached\n"
    "  3  input unreadable               7  output not writable\n"
    "  4  input refused (names atoms)   70  internal error\n";

}  // namespace morskin::app
