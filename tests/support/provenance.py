"""What mesh files say of their origin: read without the command, and judged by `check`."""

import numpy

from support.command import MOLECULES, CommandTest

CRAMBIN = MOLECULES / "1crn.pdb"


def entries(lines):
    """The keys and values of lines `... morskin: key value`."""
    return dict(line.split("morskin: ", 1)[1].split(" ", 1) for line in lines
                if "morskin: " in line)


def ply_parts(data):
    """Header lines, coordinates and faces of a PLY file without data."""
    end = data.index(b"end_header\n") + 11
    header = data[:end].decode().splitlines()
    vertices, faces = (int(line.split()[2]) for line in header if line.startswith("element"))
    body = data[end:]
    coordinates = body[:24 * vertices]
    rows = numpy.frombuffer(body[24 * vertices:], dtype=[("n", "u1"), ("corners", "<u4", 3)])
    assert len(rows) == faces
    return header, coordinates, rows["corners"].tobytes()


class ProvenanceTest(CommandTest):
    def meshed(self, *words, molecule=None, code=0):
        self.run_morskin("mesh", molecule or self.ring, "-q", *words, code=code)

    def origin(self, mesh, *words, code=0):
        return self.check(mesh, *words, code=code)["origin"]
