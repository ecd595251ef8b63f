#!/usr/bin/env python3
"""Tests of `kerf serve`: the real server, driven through its sockets.

usage: run_serve_tests.py --kerf PATH [--only TEXT] [--jobs N] [--times] [--sanitized] [--kills N] [--list]

Most of the tests wait most of the time: some run beside each other, each in a process of its own. Prints a line for each
test that fails, then `N passed, M failed`; with --times also how long each took, and the processor's time of its servers
and of itself. Exit status: 0 all passed, 1 otherwise.
"""

import argparse
import concurrent.futures
import faulthandler
import multiprocessing
import os
import resource
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
import feature_tests  # noqa: F401
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


HANGS_S = 400  # the longest test takes a tenth of it beside other work


def run(number, kerf, root):
    """Of one test: whether it passed, and the seconds of clock, of its servers and of itself."""
    sentence, function = harness.TESTS[number]
    before = spent()
    # Who hangs says where, and ends all.
    faulthandler.dump_traceback_later(HANGS_S * harness.PATIENCE, exit=True)
    passed = passes(sentence, function, harness.Place(kerf, root))
    faulthandler.cancel_dump_traceback_later()
    return passed, [now - then for now, then in zip(spent(), before)]


def spent():
    used = [resource.getrusage(who) for who in (resource.RUSAGE_CHILDREN, resource.RUSAGE_SELF)]
    return [time.monotonic(), *(one.ru_utime + one.ru_stime for one in used)]


def passes(sentence, function, place):
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
    parser.add_argument("--jobs", type=int, default=min(4, (os.cpu_count() or 1) + 1))
    parser.add_argument("--times", action="store_true")
    parser.add_argument("--sanitized", action="store_true")
    parser.add_argument("--kills", type=int, default=0)
    parser.add_argument("--list", action="store_true")
    options = parser.parse_args()
    harness.PATIENCE = 10 if options.sanitized else 1
    harness.QUARANTINE_MIB = 512 if options.sanitized else 0
    harness.KILLS = options.kills
    chosen = [n for n, (sentence, _) in enumerate(harness.TESTS) if options.only in sentence]
    if options.list:
        print("\n".join(harness.TESTS[n][0] for n in chosen))
        return 0
    passed = run_all(chosen, options)
    print(f"{passed} passed, {len(chosen) - passed} failed")
    return 0 if passed == len(chosen) > 0 else 1


def run_all(chosen, options):
    """How many pass."""
    root = Path(__file__).resolve().parents[2]
    processes = multiprocessing.get_context("fork")  # the tests are functions of this one
    with concurrent.futures.ProcessPoolExecutor(options.jobs, processes) as pool:
        runs = {pool.submit(run, n, options.kerf, root): harness.TESTS[n][0] for n in chosen}
        for done in concurrent.futures.as_completed(runs):
            if options.times:
                print("{:6.1f} s, servers {:5.2f} s, test {:5.2f} s".format(*done.result()[1]), runs[done], flush=True)
        return sum(done.result()[0] for done in runs)


if __name__ == "__main__":
    sys.exit(main())
