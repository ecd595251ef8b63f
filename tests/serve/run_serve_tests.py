#!/usr/bin/env python3
"""Tests of `kerf serve`: the real server, driven through its sockets.

usage: run_serve_tests.py --kerf PATH [--only TEXT] [--sanitized] [--kills N] [--list]

Prints a line for each test that fails, then `N passed, M failed`. Exit status: 0 all passed, 1 otherwise.
"""

import argparse
import sys
import time
import traceback
from pathlib import Path

sys.dont_write_bytecode = True

import harness

# Each of these adds its tests.
import access_tests  # noqa: F401
import budget_tests  # noqa: F401
import colour_tests  # noqa: F401
import fault_tests  # noqa: F401
import http_tests  # noqa: F401
import input_tests  # noqa: F401
import language_tests  # noqa: F401
import journal_tests  # noqa: F401
import lathe_tests  # noqa: F401
import library_tests  # noqa: F401
import link_tests  # noqa: F401
import machine_tests  # noqa: F401
import memory_tests  # noqa: F401
import part_export_tests  # noqa: F401
import pattern_tests  # noqa: F401
import stock_tests  # noqa: F401
import training_tests  # noqa: F401


def run(sentence, function, kerf, root):
    place = harness.Place(kerf, root)
    begin = time.monotonic()
    try:
        function(place)
        return True
    except Exception as problem:
        told = str(problem) if isinstance(problem, harness.Failed) else traceback.format_exc()
        logs = "".join(server.errors() for server in place.servers)
        print(f"FAILED {sentence} ({time.monotonic() - begin:.1f} s)\n  {told}\n  {logs}", flush=True)
        return False
    finally:
        place.clear()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--kerf", required=True)
    parser.add_argument("--only", default="")
    parser.add_argument("--sanitized", action="store_true")
    parser.add_argument("--kills", type=int, default=0)
    parser.add_argument("--list", action="store_true")
    options = parser.parse_args()
    harness.PATIENCE = 10 if options.sanitized else 1
    harness.QUARANTINE_MIB = 512 if options.sanitized else 0
    harness.KILLS = options.kills
    chosen = [t for t in harness.TESTS if options.only in t[0]]
    if options.list:
        print("\n".join(sentence for sentence, _ in chosen))
        return 0
    root = Path(__file__).resolve().parents[2]
    passed = sum(run(sentence, function, options.kerf, root) for sentence, function in chosen)
    print(f"{passed} passed, {len(chosen) - passed} failed")
    return 0 if passed == len(chosen) > 0 else 1


if __name__ == "__main__":
    sys.exit(main())
