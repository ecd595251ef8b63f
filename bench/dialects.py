"""What the benchmark programs share: the two dialects of G-code, how numbers are written, what a run must have done."""

from collections import Counter
from dataclasses import dataclass, field
from typing import Callable, Optional


@dataclass
class Expect:
    """What a run of a program must have done, counted while the program is written."""

    calls: Counter = field(default_factory=Counter)  # canonical calls by name, as rs274 prints them
    result: Optional[float] = None  # the value of `result_variable` at the end
    result_variable: str = ""
    cut_mm: Optional[float] = None  # length of all G01

    @property
    def cutting_moves(self) -> int:
        return self.calls["STRAIGHT_FEED"] + self.calls["ARC_FEED"]


@dataclass(frozen=True)
class Dialect:
    """The words in which the two G-code twins differ."""

    suffix: str
    opening: str
    closing: str
    dwell: Callable[[int], str]  # from milliseconds
    repeat: str  # the cycle word that drills a row of holes
    settings: tuple = ()  # blocks that set the tool lengths, where the program must do that

    def head(self, title: str) -> str:
        return f"{self.opening}({title})\nG21 G17 G90 G94 G40 G49 G80\n"


TOOL_LENGTHS = {number: 25.4 * (2 + number / 8) for number in range(1, 9)}


FANUC = Dialect(".nc", "%\nO1000\n", "M30\n%\n", lambda ms: f"P{ms}", "K",
                tuple(f"G10 L10 P{tool} R{length:.3f}" for tool, length in TOOL_LENGTHS.items()))
NGC = Dialect(".ngc", "", "M30\n", lambda ms: f"P{ms / 1000:g}", "L")


def tool_table() -> str:
    """LinuxCNC's tool table. Without a configuration rs274 reads its lengths as inches."""
    rows = (f"T{tool} P{tool} Z{length / 25.4:g} D0.25\n" for tool, length in TOOL_LENGTHS.items())
    return "".join(rows)


def number(value: float) -> str:
    """At most three decimals, always a decimal point: 12. 0.5 -3.125"""
    text = f"{value:.3f}".rstrip("0")
    return "0." if text == "-0." else text
