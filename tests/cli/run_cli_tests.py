#!/usr/bin/env python3
"""Tests of the contract of the command line (docs/command-line.md) for run, check and machines.

usage: run_cli_tests.py --kerf PATH [--only TEXT] [--jobs N] [--times] [--list]

Prints a line for each test that fails or cannot be done here, then `N passed, M failed`; with --times
also the seconds of each test. Exit status: 0 all passed, 1 otherwise.
"""

import argparse
import concurrent.futures
import os
import sys

sys.dont_write_bytecode = True  # nothing is left behind in the sources

import harness

# Each of these adds its tests.
import against_tests  # noqa: F401
import alarm_tests  # noqa: F401
import basic_tests  # noqa: F401
import check_tests  # noqa: F401
import compare_tests  # noqa: F401
import conversion_tests  # noqa: F401
import design_tests  # noqa: F401
import diagnostic_tests  # noqa: F401
import endless_tests  # noqa: F401
import engraving_tests  # noqa: F401
import draw_tests  # noqa: F401
import edit_case_tests  # noqa: F401
import edit_tests  # noqa: F401
import feature_tests  # noqa: F401
import hostile_stock_tests  # noqa: F401
import flavour_tests  # noqa: F401
import input_tests  # noqa: F401
import laser_tests  # noqa: F401
import lathe_point_tests  # noqa: F401
import lathe_post_tests  # noqa: F401
import lathe_row_tests  # noqa: F401
import library_tests  # noqa: F401
import limit_tests  # noqa: F401
import machine_tests  # noqa: F401
import motion_tests  # noqa: F401
import name_tests  # noqa: F401
import offset_tests  # noqa: F401
import option_tests  # noqa: F401
import part_check_tests  # noqa: F401
import output_tests  # noqa: F401
import pattern_tests  # noqa: F401
import plot_tests  # noqa: F401
import post_arc_tests  # noqa: F401
import post_tests  # noqa: F401
import probe_tests  # noqa: F401
import pulse_tests  # noqa: F401
import reader_tests  # noqa: F401
import journal_tests  # noqa: F401
import replay_tests  # noqa: F401
import row_tests  # noqa: F401
import saved_part_tests  # noqa: F401
import scarce_tests  # noqa: F401
import set_point_tests  # noqa: F401
import set_up_tests  # noqa: F401
import sheet_tests  # noqa: F401
import signal_tests  # noqa: F401
import state_tests  # noqa: F401
import stock_files_tests  # noqa: F401
import stock_run_tests  # noqa: F401
import stock_check_tests  # noqa: F401
import stock_tests  # noqa: F401
import teach_conversion_tests  # noqa: F401
import teach_tests  # noqa: F401
import time_tests  # noqa: F401
import turn_mill_tests  # noqa: F401
import turning_tests  # noqa: F401
import usage_tests  # noqa: F401


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--kerf", required=True, help="the program to test")
    parser.add_argument("--only", default="", help="tests whose sentence holds this text")
    parser.add_argument("--jobs", type=int, default=min(4, (os.cpu_count() or 1) + 1))
    parser.add_argument("--times", action="store_true", help="tells how long each test takes")
    parser.add_argument("--sanitized", action="store_true", help="the program carries a sanitizer")
    parser.add_argument("--list", action="store_true", help="prints the sentences only")
    options = parser.parse_args()
    program = os.path.abspath(options.kerf)
    if options.sanitized:
        harness.MEASURES_MEMORY = False
        harness.PATIENCE = 10
    tests = [test for test in harness.TESTS if options.only in test.sentence]
    sentences = [test.sentence for test in harness.TESTS + harness.LAST_TESTS]
    twice = {sentence for sentence in sentences if sentences.count(sentence) > 1}
    if twice:
        sys.exit(f"two tests have the same name: {sorted(twice)}")
    if options.list:
        print("\n".join(sentences))
        return 0
    if not os.access(program, os.X_OK):
        sys.exit(f"{program}: there is no program to test")

    report = harness.Report(options.times)
    commands = []
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for test in tests:
            pool.submit(harness.run_test, test, program, report, commands)
    if not options.only:
        for test in harness.LAST_TESTS:
            look_back = harness.Test(test.sentence,
                                     lambda box, f=test.function: f(box, list(commands)))
            harness.run_test(look_back, program, report, commands)
    if report.passed + report.failed == 0:
        print("no tests ran")
        report.failed += 1
    print(f"{report.passed} passed, {report.failed} failed")
    return 1 if report.failed else 0


if __name__ == "__main__":
    sys.exit(main())
