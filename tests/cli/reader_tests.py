"""--post, read by LinuxCNC's interpreter: rs274 cuts what Kerf cut (posted_path.py)."""

import re
import shlex
import tomllib
from pathlib import Path

from harness import check, status, test
from posted_path import Comparison, Rs274, of_records

ROOT = Path(__file__).resolve().parents[2]
INPUTS = {"--machine": 1, "--dialect": 1, "--library": 1, "--set": 1, "--param": 1,
          "--machine-set": 1, "--decimal-point": 1, "--skip-at": 1, "--tools": 1, "--offsets": 1,
          "--block-skip": 1, "--optional-stop": 0}


def length_in(program, tools):
    """A function of records, called in their order: what G43 adds to Z. In a called program it is what it
    was where that was called; the main program has no loop with a G43."""
    table = {str(tool["number"]): tool.get("length", 0) for tool in tools.get("tool", [])}
    table.update((h, float(length)) for h, length in re.findall(r"G10 L10 P(\d+) R([\d.]+)", program))
    lengths, wanted, now = [0], 0, 0
    for text in program.splitlines():
        words = re.sub(r"\(.*?\)", "", text)
        h = re.search(r"H(\d+)", words)
        if "G43" in words and h:
            wanted = now = table.get(h[1], 0)
        elif "G49" in words:
            wanted = now = 0
        elif "Z" in words:
            now = wanted
        if "G53" in words and "Z" in words:
            now = 0
        lengths.append(now)
    state = {"program": None, "now": 0}

    def length_at(record):
        state["program"] = state["program"] or record["program"]
        if record["program"] == state["program"]:
            state["now"] = lengths[record["line"]]
        return state["now"]
    return length_at


def compare(box, *command, cwd=None):
    result = box.kerf(*command, "--post", box.path("post.nc"), "--motion", box.path("motion.json"),
                      "--summary", box.path("summary.json"), cwd=cwd)
    if result.status == 1:  # by intention: the example shows an alarm
        check("post.nc" not in box.files(), "a run that ended in an alarm was posted")
        return
    status(result, 0)
    folder = Path(cwd or box.folder)
    tools = folder / command[command.index("--tools") + 1] if "--tools" in command else None
    length_at = length_in((folder / command[1]).read_text(encoding="latin-1"),
                          tomllib.loads(tools.read_text()) if tools else {})
    laser = box.json("summary.json")["machine"].startswith("laser")
    run = of_records(box.motions("motion.json"), length_at, laser)
    check(any(move["kind"] != "rapid" for move in run), "nothing is cut")
    if "drive.post_beam=M4" in command:
        run = [{**move, "s": -abs(move["s"])} for move in run]
    Comparison(run, Rs274(box.folder, "post.nc", laser).moves, laser)


def example_inputs(path):
    """The words of an example's command that say how it runs; None: it is no kerf run."""
    words = shlex.split(path.read_text())
    if words[1:2] != ["run"]:
        return None
    kept, at = ["run"], 2
    while at < len(words):
        word = words[at]
        takes = not word.startswith("-") or word == "-" or word in INPUTS
        count = INPUTS.get(word, 1 if word.startswith("--") and word != "--plot-speed" and
                           word != "--plot-energy" and word != "--keep-partial" else 0)
        if takes:
            kept += words[at:at + 1 + count]
        at += 1 + count
    return kept


# Of lathes, where LinuxCNC has other words: diameters are G7, G96 has its clamp in D, G99 is none.
LATHES = ("18_shaft", "19_bush", "20_pawn", "21_bolt_flange", "22_bushes")


def add_examples():
    for path in sorted(ROOT.glob("examples/*/command*")):
        inputs = example_inputs(path)
        if inputs and path.parent.name not in LATHES and not path.name.startswith("command_as_printed"):
            name = f"{path.parent.name}{path.name.removeprefix('command')}"
            test(f"rs274 reads the posted program of example {name} as Kerf ran it")(
                lambda box, words=inputs: compare(box, *words, cwd=ROOT))


add_examples()

BASIC = {
    "a circle and all forms of arcs":
        "speed(50)\npower(80)\nmove(10,0)\nline(20,0)\ncircle(40,40,5)\ncircle(40,40,2,5)\n"
        "arc(50,60,4,0,900)\narc(50,60,4,30,-45)\narc(50,60,4,10,-1090)\narc(50,60,4,90,450)\n"
        "move(50,50,0)\narc(60,60,0,70,50,0)\narc(80,60,20,1)\narc(100,70,-30,-1)\n"
        "arc(110,80,5,120,70,-5)\nend\n",
    "powers that change in and between cuts":
        "power(10)\nspeed(20)\nline(5,0)\npower(55.5)\nline(5,5)\npower(0)\nline(0,5)\n"
        "power(100)\nline(0,0)\nmove(3,3)\npower(30)\npower(40)\nline(9,9)\nhome\nend\n",
    "a spiral of lines":
        "speed(100)\npower(33.3)\nfor i=1 to 200\nline(i*cos(i/9)/8, i*sin(i/9)/8, i/300)\nnext\nend\n",
}


def basic(program, *words):
    def run(box):
        box.write("part.bas", program)
        compare(box, "run", "part.bas", *words)
    return run


for title, text in BASIC.items():
    test(f"rs274 reads posted laser BASIC, {title}, as Kerf ran it")(basic(text))
test("rs274 reads the posted beam of M4 as that of M3")(
    basic(BASIC["powers that change in and between cuts"], "--machine-set", "drive.post_beam=M4"))
