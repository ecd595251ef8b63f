#!/usr/bin/env python3
"""tools/third_party.py: writes THIRD_PARTY_NOTICES, the licences of what others wrote and Kerf is made with.

What that is, is looked up and not listed by hand: the headers that were compiled into the program and the libraries that it
asks for, by the Debian packages that they come from; and the npm packages whose modules are in the page, by the last build of it.
Parts of the compiler and of the C library belong to the system and are left out.

  tools/third_party.py [--build FOLDER]           writes the file
  tools/third_party.py [--build FOLDER] --check   says what it names too much or too little; writes nothing

Run it behind tools/build. Status: 0 well · 1 the file is not up to date · 3 there is no build to look at.
"""

import argparse
import fnmatch
import functools
import json
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
NOTICES = ROOT / "THIRD_PARTY_NOTICES"
WEB = ROOT / "web"
SHIPPED = WEB / "node_modules" / ".shipped.json"
SYSTEM = re.compile(r"glibc|linux|gcc-.*|llvm-toolchain-.*")
RULE = "=" * 80

PREFACE = """Notices of third parties

Kerf itself is under the Apache License 2.0 (LICENSE). This file has the licences of what others wrote: parts that
are compiled into the program `kerf` or that it loads when it starts, and packages that are in the page which it serves.

"""


def output_of(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


# The program


def headers(build):
    """Of all sources of the program, without those of tests."""
    found = set()
    ours = False
    for line in output_of("ninja", "-C", str(build), "-t", "deps").splitlines():
        if line and not line.startswith(" "):
            ours = line.startswith("src/")
        elif ours and line.strip().startswith("/usr/"):
            found.add(line.strip())
    return found


def libraries(build):
    needed = re.findall(r"NEEDED.*\[(.+)\]", output_of("readelf", "-d", str(build / "bin" / "kerf")))
    places = dict(re.findall(r"^\s*(\S+) \(libc6,[^)]*\) => (\S+)", output_of("/sbin/ldconfig", "-p"), re.M))
    return {str(Path(places[name]).resolve()) for name in needed if name in places}


def packages_of(files):
    """Debian packages, each with those of the files that are its own."""
    owners = {}
    names = sorted(files)
    found = subprocess.run(["dpkg", "-S", *names], capture_output=True, text=True).stdout
    for line in found.splitlines():
        package, _, path = line.partition(": ")
        owners.setdefault(package.split(",")[0].split(":")[0], set()).add(path)
    return owners


def source_of(package):
    name, version = output_of("dpkg-query", "-W", "-f", "${source:Package} ${source:Version}", package).split()
    return name, re.sub(r"^\d+:|[-+~](dfsg|ds|deb|\d).*$", "", version)


def components_of_program(build):
    """By the name of the source: its version, and per Debian package the files that are used."""
    found = {}
    for package, files in packages_of(headers(build) | libraries(build)).items():
        name, version = source_of(package)
        if not SYSTEM.fullmatch(name):
            found.setdefault(name, (version, {}))[1][package] = files
    return found


def paragraphs(text):
    """Of a copyright file in Debian's machine-readable form."""
    for block in re.split(r"\n\s*\n", text):
        fields, key = {}, None
        for line in block.splitlines():
            match = re.match(r"([A-Za-z-]+):\s*(.*)", line)
            if match and not line.startswith(" "):
                key = match[1]
                fields[key] = match[2]
            elif key:
                fields[key] += "\n" + line.strip()
        yield fields


@functools.cache
def expression(patterns):
    return re.compile("|".join(fnmatch.translate(pattern) for pattern in patterns.split()))


def matches(path, patterns):
    """Whether they mean a header, which lies elsewhere in its source than where it is installed."""
    inner = re.sub(r"^/usr/(include|lib)/", "", path)
    first = inner.split("/")[1].split(".")[0] if inner.count("/") else inner
    forms = (inner, f"include/{inner}", f"libs/{first}/include/{inner}", f"src/{inner}")
    return any(expression(patterns).match(form) for form in forms)


def tidy(text):
    return "\n".join("" if line.strip() == "." else line.rstrip() for line in text.strip("\n").splitlines())


def licence_of_package(package, files):
    """The paragraphs that speak of these files; all of the file where it has none."""
    text = Path(f"/usr/share/doc/{package}/copyright").read_text()
    if not text.startswith("Format:"):
        return tidy(text)
    stanzas = list(paragraphs(text))
    said, names = [], []
    for path in sorted(files):
        last = None
        for stanza in stanzas:
            if "Files" in stanza and not stanza["Files"].startswith("debian/") and matches(path, stanza["Files"]):
                last = stanza
        if last is None:
            continue
        holder = tidy(last.get("Copyright", ""))
        if holder and holder not in said:
            said.append(holder)
        licence = last.get("License", "")
        if licence not in names:
            names.append(licence)
    texts = []
    for licence in names:
        words = set(re.split(r"\s+(?:and|or|with)\s+|,", licence.splitlines()[0]))
        if "\n" in licence:
            texts.append(tidy(licence))
            continue
        for stanza in stanzas:
            own = stanza.get("License", "")
            if "Files" not in stanza and own.splitlines()[:1] and own.splitlines()[0].strip() in words:
                texts.append(tidy(own))
    return "\n\n".join(["\n".join(f"Copyright: {one}" for one in said), *dict.fromkeys(texts)]).strip()


def without_paths(text):
    """The places of one computer say nothing on another."""
    return re.sub(r"<?(file://)?/usr/share/\S*", "the system's common licences", text)


# The page


def components_of_page():
    """By name: version and text."""
    locked = json.loads((WEB / "package-lock.json").read_text())["packages"]
    found = {}
    for name in json.loads(SHIPPED.read_text()):
        folder = WEB / "node_modules" / name
        files = sorted(f for f in folder.iterdir() if re.match(r"(?i)(licen[cs]e|copying|notice)", f.name))
        text = "\n\n".join(f.read_text() for f in files) or f"License: {locked['node_modules/' + name]['license']}"
        found[name] = (locked[f"node_modules/{name}"]["version"], tidy(text))
    return found


# The file


def entry(name, version, where, text):
    return f"{RULE}\n{name} {version}, {where}\n{RULE}\n\n{text}\n\n"


def notices(program, page):
    text = PREFACE
    for name in sorted(program):
        version, packages = program[name]
        texts = dict.fromkeys(licence_of_package(package, files) for package, files in sorted(packages.items()))
        text += entry(name, version, "in the program", without_paths("\n\n".join(t for t in texts if t)))
    for name in sorted(page):
        version, licence = page[name]
        text += entry(name, version, "in the page", licence)
    return text.rstrip("\n") + "\n"


def named():
    """What the file names: (name, version, where)."""
    text = NOTICES.read_text() if NOTICES.exists() else ""
    return set(re.findall(rf"^{RULE}\n(\S+) (\S+), in the (program|page)\n{RULE}$", text, re.M))


def locked_packages():
    """All of them, and those that the page asks for itself: (name, version)."""
    packages = json.loads((WEB / "package-lock.json").read_text())["packages"]
    locked = {(name[len("node_modules/") :], one["version"]) for name, one in packages.items() if name}
    asked = packages[""]["dependencies"]
    return locked, {(name, version) for name, version in locked if name in asked}


def check(build):
    wrong = []
    there = named()
    program = set(components_of_program(build))
    listed = {name for name, _version, where in there if where == "program"}
    wrong += [f"{name} is in the program, and has no notice" for name in sorted(program - listed)]
    wrong += [f"{name} has a notice, and is not in the program" for name in sorted(listed - program)]
    page = {(name, version) for name, version, where in there if where == "page"}
    locked, asked = locked_packages()
    must = {(n, v) for n, (v, _) in components_of_page().items()} if SHIPPED.exists() else asked
    wrong += [f"{name} {version} is in the page, and has no notice" for name, version in sorted(must - page)]
    wrong += [f"{name} {version} has a notice, and is not locked" for name, version in sorted(page - locked)]
    if SHIPPED.exists():
        wrong += [f"{name} {version} has a notice, and is not in the page" for name, version in sorted(page - must)]
    text = NOTICES.read_text() if NOTICES.exists() else ""
    wrong += [f"names {word}" for word in ("/usr/", "/home/", "/root/", "registry.") if word in text]
    return wrong


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", type=Path, default=ROOT / "build" / "release")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    if not (options.build / "build.ninja").exists():
        print(f"kerf: there is no build in {options.build}", file=sys.stderr)
        return 3
    if options.check:
        wrong = check(options.build)
        for sentence in wrong:
            print(f"THIRD_PARTY_NOTICES: {sentence}; run tools/third_party.py", file=sys.stderr)
        return 1 if wrong else 0
    if not SHIPPED.exists():
        print("kerf: the page has not been built; run tools/build_web", file=sys.stderr)
        return 3
    NOTICES.write_text(notices(components_of_program(options.build), components_of_page()))
    return 0


if __name__ == "__main__":
    sys.exit(main())
