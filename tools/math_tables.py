#!/usr/bin/env python3
"""Computes the tables of src/math by whole numbers of any length, and writes the headers of them in src/math/internal.

Every value is a pair of doubles: the nearest one, and the nearest to what is left.

usage: math_tables.py [--check]      --check: exit 1 when a file differs from what would be written
"""

import sys
from fractions import Fraction
from pathlib import Path

FOLDER = Path(__file__).resolve().parent.parent / "src/math/internal"
BITS = 400  # of a sum, behind the point
ONE = 1 << BITS


def sine_cosine(x: Fraction) -> tuple[Fraction, Fraction]:
    """Sine and cosine of 0 <= x < 1 by their series."""
    sums = [0, 0]
    term = ONE
    n = 0
    angle = ONE * x.numerator // x.denominator
    while term:
        sums[n % 2] += -term if n % 4 >= 2 else term
        n += 1
        term = (term * angle >> BITS) // n
    return Fraction(sums[1], ONE), Fraction(sums[0], ONE)


def arctangent(x: Fraction) -> Fraction:
    """Of 0 <= x <= 1: Euler's series, which converges for x = 1 too."""
    square = Fraction(x * x, 1 + x * x)
    factor = ONE * square.numerator // square.denominator
    first = x / (1 + x * x)
    term = ONE * first.numerator // first.denominator
    total = 0
    n = 0
    while term:
        total += term
        n += 1
        term = (term * factor >> BITS) * (2 * n) // (2 * n + 1)
    return Fraction(total, ONE)


def logarithm(x: Fraction) -> Fraction:
    """Of 1/2 <= x <= 2: twice the inverse hyperbolic tangent of (x - 1) / (x + 1)."""
    z = (x - 1) / (x + 1)
    sign = -1 if z < 0 else 1
    z = abs(z)
    power = ONE * z.numerator // z.denominator
    square = power * power >> BITS
    total = 0
    n = 1
    while power:
        total += power // n
        power = power * square >> BITS
        n += 2
    return sign * Fraction(2 * total, ONE)


def exponential(x: Fraction) -> Fraction:
    """Of 0 <= x < 1, by its series."""
    total = 0
    term = ONE
    n = 0
    argument = ONE * x.numerator // x.denominator
    while term:
        total += term
        n += 1
        term = (term * argument >> BITS) // n
    return Fraction(total, ONE)


PI = 16 * arctangent(Fraction(1, 5)) - 4 * arctangent(Fraction(1, 239))
LN2 = logarithm(Fraction(2))
LN10 = 3 * LN2 + logarithm(Fraction(10, 8))


def shortened(x: Fraction, bits: int) -> Fraction:
    """x cut to its leading bits."""
    exponent = 0
    while x < 1 << (bits - 1):
        x, exponent = x * 2, exponent + 1
    while x >= 1 << bits:
        x, exponent = x / 2, exponent - 1
    return Fraction(int(x)) / Fraction(2) ** exponent


def text(x: float) -> str:
    return "0.0" if x == 0 else x.hex()


def pair(x: Fraction) -> str:
    high = float(x)
    return f"{{{text(high)}, {text(float(x - Fraction(high)))}}}"


def parts(x: Fraction, bits: int, count: int) -> list[str]:
    """x as a sum: `count` numbers of so many bits, and the rest."""
    numbers = []
    for _ in range(count):
        part = shortened(x, bits)
        numbers.append(text(float(part)))
        x -= part
    return numbers + [text(float(x))]


def table(name: str, comment: str, rows: list[str], kind: str = "Pair") -> str:
    body = "".join(f"    {row},\n" for row in rows)
    return f"/// {comment}\ninline constexpr {kind} {name}[] = {{\n{body}}};\n"


def constant(name: str, value: str) -> str:
    return f"inline constexpr Pair {name}{value};\n"


def reciprocal(i: int) -> Fraction:
    """About 1 / m for m in the i-th of 128 intervals of [1, 2); above sqrt(2) of m / 2. 1 beside 1."""
    middle = 1 + Fraction(2 * i + 1, 256)
    if i in (0, 127):
        return Fraction(1)
    if middle > Fraction(1414214, 1000000):
        middle /= 2
    return Fraction(round(1 / middle * 2048), 2048)


def two_over_pi_words() -> list[str]:
    """2/pi behind the point, 32 bits each: enough for every double (1024 + 53 + 128 bits)."""
    count = 40
    numerator = 2 * (1 << 32 * count)
    digits = int(Fraction(numerator) / pi_of(32 * count + 64))
    return [f"0x{digits >> 32 * (count - 1 - i) & 0xFFFFFFFF:08x}" for i in range(count)]


def pi_of(bits: int) -> Fraction:
    global BITS, ONE
    kept = BITS
    BITS = bits + 64
    ONE = 1 << BITS
    value = 16 * arctangent(Fraction(1, 5)) - 4 * arctangent(Fraction(1, 239))
    BITS = kept
    ONE = 1 << BITS
    return value


def header(tables: list[str]) -> str:
    return "\n".join(
        [
            "// Written by tools/math_tables.py; do not edit.\n// clang-format off\n#pragma once\n",
            "#include <cstdint>\n",
            '#include "math/internal/pair.hpp"\n',
            "namespace kerf::math {\n",
            *tables,
            "}  // namespace kerf::math\n",
        ]
    )


def trigonometric_tables() -> str:
    angles = [Fraction(k, 64) for k in range(52)]
    words = two_over_pi_words()
    lines = [", ".join(words[i : i + 8]) for i in range(0, len(words), 8)]
    return header(
        [
            constant("kPi", pair(PI))
            + constant("kHalfPi", pair(PI / 2))
            + f"inline constexpr double kTwoOverPi = {text(float(2 / PI))};\n",
            table("kHalfPiParts", "pi/2 in parts of 33 bits and a rest.", parts(PI / 2, 33, 3), "double"),
            table("kTwoOverPiWords", "2/pi behind the point, 32 bits each.", lines, "std::uint32_t"),
            table("kSines", "sin(k/64).", [pair(sine_cosine(x)[0]) for x in angles]),
            table("kCosines", "cos(k/64).", [pair(sine_cosine(x)[1]) for x in angles]),
            table("kArctangents", "atan(k/64).", [pair(arctangent(Fraction(k, 64))) for k in range(65)]),
        ]
    )


def exponential_tables() -> str:
    reciprocals = [reciprocal(i) for i in range(128)]
    return header(
        [
            constant("kOverLn2", pair(1 / LN2))
            + constant("kOverLn10", pair(1 / LN10))
            + f"inline constexpr double k64OverLn2 = {text(float(64 / LN2))};\n",
            table("kLn2Parts", "ln 2 in a part of 42 bits and a rest.", parts(LN2, 42, 1), "double"),
            table("kLn2Over64Parts", "ln 2 / 64 in parts of 36 bits and a rest.", parts(LN2 / 64, 36, 2), "double"),
            table("kPowersOf2", "2^(k/64).", [pair(exponential(LN2 * k / 64)) for k in range(64)]),
            table(
                "kReciprocals",
                "c, about 1/m where m is in the k-th of 128 intervals of [1, 2); of m/2 above sqrt(2).",
                [text(float(c)) for c in reciprocals],
                "double",
            ),
            table("kLogarithms", "-ln(c) of kReciprocals.", [pair(-logarithm(c)) for c in reciprocals]),
        ]
    )


def main() -> int:
    wanted = {"trigonometric_tables.hpp": trigonometric_tables(), "exponential_tables.hpp": exponential_tables()}
    stale = []
    for name, content in wanted.items():
        file = FOLDER / name
        if "--check" not in sys.argv[1:]:
            file.write_text(content, encoding="utf-8")
        elif not file.exists() or file.read_text(encoding="utf-8") != content:
            stale.append(name)
    for name in stale:
        print(f"{name} is not what tools/math_tables.py writes", file=sys.stderr)
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main())
