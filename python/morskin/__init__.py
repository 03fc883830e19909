"""morskin: certified triangle meshes of molecular skin surfaces.

    import morskin
    mesh = morskin.read("1crn.pdb").mesh(density=5)
    mesh.save("1crn.ply")

Lengths are in Angstrom. The same input gives the same arrays on any number of threads.
"""

from . import adapters
from ._morskin import (Certificate, CriticalPoints, Mesh, MorseSmaleComplex, Skin, __version__,
                       check, read_mesh, van_der_waals_radius)
from .errors import (Error, InternalError, LimitReached, NotCertified, RefusedInput,
                     UnreadableInput, UnwritableOutput)
from .molecule import Molecule, features, read

__all__ = [
    "Certificate", "CriticalPoints", "Error", "InternalError", "LimitReached", "Mesh", "Molecule",
    "MorseSmaleComplex", "NotCertified", "RefusedInput", "Skin", "UnreadableInput",
    "UnwritableOutput", "__version__", "adapters", "check", "features", "read", "read_mesh",
    "van_der_waals_radius",
]
