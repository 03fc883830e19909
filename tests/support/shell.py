"""An interactive shell in a terminal of its own, to see what it completes."""

import os
import pty
import select
import subprocess
import time

# The command is a function that keeps its words; the prompt is what to wait for.
SETUP = {
    "bash": """
bind 'set bell-style none'; bind 'set enable-bracketed-paste off'
source "$COMPLETIONS/morskin.bash"
morskin() { printf '%s\\n' "$@" > words; }
PS1='rea''dy>'
""",
    "zsh": """
fpath=("$COMPLETIONS" $fpath); autoload -Uz compinit; compinit -u -D
zstyle ':completion:*' insert-tab false; unsetopt beep prompt_sp auto_remove_slash
morskin() { printf '%s\\n' "$@" > words; }
PS1='rea''dy>'
""",
}
START = {"bash": ["bash", "--norc", "--noprofile", "-i"], "zsh": ["zsh", "-f", "-i"]}
PATIENCE = 60  # seconds, for a busy machine


class Shell:
    """Works in `folder`; `completions` holds the files that the build makes."""

    def __init__(self, name, folder, completions):
        self.words = folder / "words"
        self.terminal, inside = pty.openpty()
        (folder / "setup").write_text(SETUP[name])
        self.process = subprocess.Popen(
            START[name], stdin=inside, stdout=inside, stderr=inside, cwd=folder,
            start_new_session=True,
            env={"PATH": os.environ["PATH"], "HOME": str(folder), "TERM": "xterm", "LC_ALL": "C",
                 "COMPLETIONS": str(completions)})
        os.close(inside)
        self.type(" source ./setup\n")

    def type(self, text):
        """Types, and waits for the prompt that follows."""
        os.write(self.terminal, text.encode())
        said, end = b"", time.monotonic() + PATIENCE
        while b"ready>" not in said.rpartition(b"\n")[2]:
            ready, _, _ = select.select([self.terminal], [], [], end - time.monotonic())
            if not ready:
                raise AssertionError(f"no prompt after {text!r}: {said!r}")
            said += os.read(self.terminal, 1 << 16)

    def completed(self, line):
        """The words of a line after Tab has been pressed at its end."""
        self.words.unlink(missing_ok=True)
        self.type(line + "\t\n")
        return self.words.read_text().splitlines() if self.words.exists() else None

    def close(self):
        self.process.kill()
        self.process.wait()
        os.close(self.terminal)
