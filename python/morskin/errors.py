"""What goes wrong: one class for each exit code of the command."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ._morskin import Mesh


class Error(Exception):
    """Anything that morskin raises of its own; the text says what is wrong.

    atoms  those that it is about, counted from 0; often none
    """

    atoms: tuple[int, ...] = ()


class UnreadableInput(Error, OSError):
    """A file that is missing, damaged or of an unknown format; the text names file and line."""


class RefusedInput(Error, ValueError):
    """What can be understood, but not done: no atoms, a radius that is none, a skin that touches
    itself, a direction that is degenerate, options that make no sense."""


class NotCertified(Error):
    """The mesh was made, but the certificate does not cover it.

    mesh  it; `Skin.mesh(allow_uncertified=True)` returns it. An error that comes from another
          process, as from a pool's worker, has none
    """

    mesh: Mesh

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), self.args, {k: v for k, v in vars(self).items() if k != "mesh"}

    def __copy__(self) -> NotCertified:
        copied = type(self)(*self.args)
        copied.__dict__.update(vars(self))
        return copied

    def __deepcopy__(self, _: dict[int, Any]) -> NotCertified:
        return self.__copy__()  # meshes never change


class LimitReached(Error, MemoryError):
    """Memory, threads, or what 32-bit ids can tell apart."""


class UnwritableOutput(Error, OSError):
    """A file that cannot be written; nothing half-written is left."""


class InternalError(Error, RuntimeError):
    """A fault of morskin; please report it with the input."""
