#!/usr/bin/env python3
"""Holds tools/build against what it tells while it builds: how far it is on a terminal, nothing of that elsewhere.

A copy of the script runs in a folder of its own; the cmake that it finds says what ninja would.

usage: build_test.py
"""

import os
import pty
import re
import shutil
import tempfile
import unittest
from pathlib import Path
from typing import Iterable, NamedTuple, Optional

SCRIPT = Path(__file__).resolve().parents[2] / "tools/build"
FILES = 100
# So far apart that a computer which stops for seconds between two of them makes the time left no longer.
OVER = [1, 10, 24, 25, 50, 75, 99]
FIRST_QUARTER_S = 3.1  # more than a minute is left then

PROGRESS = re.compile(r"kerf: (\d+) of (\d+)(?:, (?:(\d+) min )?(\d+) s left)? ")


class Run(NamedTuple):
    status: int
    terminal: str  # what the terminal got, as it got it, or the file that errors went into
    log: str
    root: str
    built: Optional[str]  # the mark of a good build


def ninja(counts: Iterable[int]) -> str:
    """Commands that tell of so many files as ninja does."""
    return "\n".join(f"echo '[{over}/{FILES}] Building CXX object file_{over}.o'" for over in counts)


def on_terminal(command: str, environment: dict[str, str]) -> tuple[int, str]:
    """Status of a shell's command whose terminal is a new one, and what it wrote there."""
    child, terminal = pty.fork()
    if child == 0:
        os.execvpe("bash", ["bash", "-c", command], environment)
    written = b""
    try:
        while piece := os.read(terminal, 65536):
            written += piece
    except OSError:  # the other end is closed
        pass
    os.close(terminal)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), written.decode()


def build(says: str, redirect: str = "") -> Run:
    """The script, with a cmake that does `says` when it shall build."""
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder).resolve()
        (root / "tools").mkdir()
        (root / "bin").mkdir()
        shutil.copy(SCRIPT, root / "tools/build")
        cmake = root / "bin/cmake"
        cmake.write_text(f"#!/usr/bin/env bash\n[[ $1 == --build ]] || exit 0\n{says}\n")
        cmake.chmod(0o755)
        environment = os.environ | {"PATH": f"{root}/bin:{os.environ['PATH']}", "CCACHE_DIR": f"{root}/ccache"}
        status, terminal = on_terminal(f"'{root}/tools/build' release {redirect.format(root=root)}", environment)
        told = root / "told"
        built = root / "build/release/.built"
        return Run(
            status,
            terminal + (told.read_text() if told.exists() else ""),
            (root / "build/release/build.log").read_text(),
            str(root),
            built.read_text() if built.exists() else None,
        )


def shown(run: Run) -> list[tuple[int, Optional[int]]]:
    """What the progress line said, one after the other: how many are over, and the seconds left."""
    lines = []
    for over, count, minutes, seconds in PROGRESS.findall(run.terminal):
        assert int(count) == FILES, run.terminal
        lines.append((int(over), int(minutes or 0) * 60 + int(seconds) if seconds else None))
    return lines


def screen(terminal: str) -> list[str]:
    """The lines that stand on the terminal at the end."""
    lines = []
    for line in terminal.replace("\r\n", "\n").split("\n"):
        stands = ""
        for piece in line.split("\r"):
            text, *erased = piece.split("\x1b[K")
            stands = text + "".join(erased) + ("" if erased else stands[len(text) :])
        lines.append(stands)
    return lines


class Progress(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.good = build(f"{ninja(OVER[:2])}\nsleep {FIRST_QUARTER_S}\n{ninja([*OVER[2:], FILES])}")

    def test_a_terminal_sees_how_many_are_over(self):
        self.assertEqual([over for over, _ in shown(self.good)], OVER)

    def test_the_time_left_is_told_from_a_quarter_on_and_falls(self):
        left = dict(shown(self.good))
        self.assertEqual([over for over in OVER if left[over] is None], [1, 10, 24])
        seconds = [left[over] for over in (25, 50, 75, 99)]
        self.assertGreaterEqual(seconds[0], 60)
        self.assertEqual(seconds, sorted(set(seconds), reverse=True))

    def test_nothing_of_it_stands_when_all_is_built(self):
        self.assertEqual(self.good.status, 0, self.good)
        self.assertNotIn(f"{FILES} of {FILES}", self.good.terminal)
        self.assertEqual(screen(self.good.terminal), [f"kerf: building {self.good.root}/build/release", ""])

    def test_the_log_has_every_line(self):
        self.assertEqual(len(self.good.log.splitlines()), len(OVER) + 1)
        self.assertEqual(self.good.built, f"{self.good.root}\n")

    def test_a_few_files_are_not_counted(self):
        few = build("echo '[1/9] Building CXX object file.o'")
        self.assertEqual(shown(few), [])

    def test_nothing_is_shown_where_errors_go_into_a_file(self):
        quiet = build(ninja(range(1, FILES + 1)), "2>{root}/told")
        self.assertEqual(quiet.status, 0, quiet)
        self.assertEqual(quiet.terminal, f"kerf: building {quiet.root}/build/release\n")

    def test_a_failed_build_is_told_with_the_end_of_its_log(self):
        says = f"{ninja(range(1, 51))}\necho 'file_51.cpp:1: error: wrong'; echo 'ninja: build stopped' >&2; exit 1"
        for redirect in ("", "2>{root}/told"):
            with self.subTest(redirect):
                failed = build(says, redirect)
                self.assertEqual(failed.status, 4, failed)
                self.assertIsNone(failed.built)
                lines = screen(failed.terminal)
                self.assertEqual(lines[1:-2], failed.log.splitlines()[-40:])
                self.assertIn("file_51.cpp:1: error: wrong", lines)
                self.assertEqual(
                    lines[-2:], [f"kerf: the build failed; all of it is in {failed.root}/build/release/build.log", ""]
                )


if __name__ == "__main__":
    unittest.main()
