"""What the tests of the command line share: a folder of their own, the program, and checks that say
what was wanted and what came.

A test is a function with one parameter, a Box, under @test("a sentence").
"""

import json
import os
import shlex
import shutil
import subprocess
import sys
import tempfile
import threading
import time

# Whoever has not ended by then hangs, however busy the machine is.
TIMEOUT_S = 150

# A sanitizer needs memory and time of its own: then nothing is said about the memory of Kerf, and
# each limit of time is this many times as long.
MEASURES_MEMORY = True
PATIENCE = 1

# Runs the words behind the first two and writes the peak memory (KiB) of that process to the first.
# A process starts out with the peak of the one that made it, so a small one has to stand between.
PEAK_SCRIPT = """
import os, sys
pid = os.posix_spawnp(sys.argv[2], sys.argv[2:], os.environ)
status, usage = os.wait4(pid, 0)[1:]
open(sys.argv[1], "w").write(str(usage.ru_maxrss))
sys.exit(os.waitstatus_to_exitcode(status) & 255)
"""


class Failed(Exception):
    """A check did not hold."""


class Skipped(Exception):
    """The test cannot be done here; the text says why."""


class Result:
    def __init__(self, command, status, out, err, seconds, peak_kib=0):
        self.command = command
        self.status = status
        self.out = out  # bytes
        self.err = err.decode("utf-8", "surrogateescape")
        self.seconds = seconds
        self.peak_kib = peak_kib

    @property
    def text(self):
        return self.out.decode("utf-8")

    def lines(self):
        return self.text.splitlines()


class Box:
    """A folder with nothing in it, and the program that is tested."""

    def __init__(self, program, folder):
        self.program = program
        self.folder = folder
        self.commands = []
        self.used = []  # commands that were no wrong usage

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def write(self, name, content):
        """Writes a file; returns its name as it is used on the command line."""
        path = self.path(name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "wb") as file:
            file.write(content if isinstance(content, bytes) else content.encode())
        return name

    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def json(self, name):
        return json.loads(self.read(name))

    def motions(self, name):
        return [json.loads(line) for line in self.read(name).splitlines()]

    def files(self, folder=""):
        return sorted(os.listdir(self.path(folder)))

    def kerf(self, *words, stdin=b"", cwd=None, before=(), peak=False, environment=None):
        """Runs kerf in the box. `before`: words in front of it, such as ("unshare", "-m", …)."""
        command = [*before, self.program, *words]
        self.commands.append(command)
        peak_file = None
        if peak:
            peak_file = tempfile.NamedTemporaryFile(prefix="kerf-peak-")
            command = [sys.executable, "-I", "-S", "-c", PEAK_SCRIPT, peak_file.name, *command]
        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
            begin = time.monotonic()
            try:
                process = subprocess.Popen(command, cwd=cwd or self.folder, stdout=out, stderr=err,
                                           stdin=subprocess.PIPE, env=environment)
                process.communicate(stdin if isinstance(stdin, bytes) else stdin.encode(),
                                    timeout=TIMEOUT_S * PATIENCE)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
                raise Failed(f"no end after {TIMEOUT_S * PATIENCE} s: {shell_text(command)}") from None
            seconds = time.monotonic() - begin
            if process.returncode in (0, 1, 5):
                self.used.append(command)
            out.seek(0)
            err.seek(0)
            peak_kib = int(peak_file.read() or 0) if peak_file else 0
            return Result(command, process.returncode, out.read(), err.read(), seconds, peak_kib)

    def start(self, *words, **options):
        """Starts kerf and does not wait for it."""
        self.commands.append([self.program, *words])
        return subprocess.Popen([self.program, *words], cwd=self.folder, stdin=subprocess.DEVNULL,
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, **options)


def shell_text(command):
    """A command for a reader: long words shortened."""
    words = [word if len(word) < 60 else word[:57] + "..." for word in command]
    return shlex.join(words).replace("\n", "\\n")


def shortened(value, most=300):
    text = value if isinstance(value, str) else repr(value)
    return text if len(text) <= most else text[:most] + f"... ({len(text)} characters)"


def check(good, message):
    if not good:
        raise Failed(message)


def equal(got, wanted, what):
    check(got == wanted, f"{what}: {shortened(got)}, wanted {shortened(wanted)}")


def near(got, wanted, tolerance, what):
    check(abs(got - wanted) <= tolerance, f"{what}: {got}, wanted {wanted} within {tolerance}")


def contains(text, part, what):
    check(part in text, f"{what} has no {part!r}: {shortened(text)}")


def status(result, wanted):
    check(result.status == wanted,
          f"exit status {result.status}, wanted {wanted}; standard error: {shortened(result.err)}")


def one_sentence(result, *parts):
    """Standard error is one line of Kerf's own that names `parts`, standard output empty."""
    lines = result.err.splitlines()
    check(len(lines) == 1 and lines[0].startswith("kerf: ") and result.err.endswith("\n"),
          f"standard error must be one sentence 'kerf: …': {shortened(result.err)}")
    check(all(c.isprintable() for c in lines[0]),
          f"the sentence holds control characters: {lines[0]!r}")
    check(len(lines[0]) < 300,
          f"the sentence has {len(lines[0])} characters: {shortened(lines[0], 100)}")
    for part in parts:
        contains(lines[0], part, "the sentence")
    equal(result.out, b"", "standard output")


def in_time(result, most_s):
    """Of a machine that others keep busy, we have only a part."""
    busy = max(1, os.getloadavg()[0] / os.cpu_count())
    check(result.seconds < most_s * PATIENCE * busy, f"it took {result.seconds:.1f} s")


def refused(result, wanted, *parts):
    """The command did nothing and said why in one sentence."""
    status(result, wanted)
    one_sentence(result, *parts)


def alarm(result, number, line=None):
    """The run ended in this alarm."""
    status(result, 1)
    first = result.err.splitlines()[0]
    contains(first, f" error: {number} ", "the diagnostic")
    if line is not None:
        contains(first, f":{line}:", "the diagnostic")


class Test:
    def __init__(self, sentence, function):
        self.sentence = sentence
        self.function = function


TESTS = []
LAST_TESTS = []  # look at what the others did


def test(sentence):
    def add(function):
        TESTS.append(Test(sentence, function))
        return function
    return add


def last_test(sentence):
    """A test behind all others; its function takes the command lines that were no wrong usage."""
    def add(function):
        LAST_TESTS.append(Test(sentence, function))
        return function
    return add


class Report:
    """Counts what comes and prints a line for each test that fails, or its time for each."""

    def __init__(self, tells_times=False):
        self.tells_times = tells_times
        self.passed = self.failed = self.skipped = 0
        self.lock = threading.Lock()

    def tell(self, outcome, name, message, command, seconds):
        with self.lock:
            setattr(self, outcome, getattr(self, outcome) + 1)
            if self.tells_times:
                print(f"{seconds:6.1f} s  {name}", flush=True)
            if outcome != "passed":
                hint = f" [{shell_text(command)}]" if command and outcome == "failed" else ""
                print(f"{outcome.upper()} {name}: {' '.join(message.split())}{hint}", flush=True)


def run_test(item, program, report, commands):
    folder = tempfile.mkdtemp(prefix="kerf-cli-")
    box = Box(program, folder)
    outcome, message = "passed", ""
    began = time.monotonic()
    try:
        item.function(box)
    except Failed as failure:
        outcome, message = "failed", str(failure)
    except Skipped as reason:
        outcome, message = "skipped", str(reason)
    except Exception as error:  # a test that breaks is a test that fails
        place = error.__traceback__
        while place.tb_next:
            place = place.tb_next
        outcome = "failed"
        message = (f"{type(error).__name__}: {error} "
                   f"({os.path.basename(place.tb_frame.f_code.co_filename)}:{place.tb_lineno})")
    finally:
        os.chmod(folder, 0o755)
        shutil.rmtree(folder, ignore_errors=True)
    commands.extend(box.used)
    report.tell(outcome, item.sentence, message, box.commands[-1] if box.commands else None,
                time.monotonic() - began)
