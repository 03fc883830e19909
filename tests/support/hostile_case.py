"""A case of input that means harm, or might."""


class Case:
    """One line of the table.

    files    name -> bytes or text, made beforehand; a name that ends in / is a folder
    runs     argument lists; default: mesh FIRST_FILE -o out.ply
    code     expected of every run
    says     a piece of what each says on standard error
    leaves   files that must be there afterwards, beside those made; None: out.ply if code is 0
    """

    def __init__(self, what, files=(), runs=None, code=0, says="", leaves=None, **how):
        self.what = what
        self.files = dict(files)
        first = next(iter(self.files), None)
        self.runs = runs or [("mesh", first, "-o", "out.ply")]
        self.code = code
        self.says = says
        self.leaves = set(leaves) if leaves is not None else {"out.ply"} if code == 0 else set()
        self.how = how


def mesh(name, *words):
    return ("mesh", name, "-o", "out.ply", *words)


def all_models(name, *words):
    return [mesh(name, *words, "--model", model) for model in ("paper", "sas", "vdw")]


def xyzr(balls):
    return "".join(" ".join(repr(float(number)) for number in ball) + "\n" for ball in balls)
