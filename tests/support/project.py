"""What the test scripts share: where things are, and what CMakeLists.txt and the headers say of the topics."""
import fcntl
import os
import pathlib
import re
import shutil
import subprocess
from dataclasses import dataclass

import programs

programs.use_nothing_else()
ROOT = pathlib.Path(os.environ.get("GRADUS_SOURCE_DIR", pathlib.Path(__file__).resolve().parents[2]))
BUILD = pathlib.Path(os.environ.get("GRADUS_BINARY_DIR", ROOT / "build/release"))
COMMAND = pathlib.Path(os.environ.get("GRADUS_COMMAND", BUILD / "gradus"))
COMPILER = os.environ.get("CXX", "c++")


@dataclass(frozen=True)
class Topic:
    path: str  # scan_conversion/bresenham_line
    depends: tuple = ()
    partial: bool = False

    @property
    def name(self):
        return self.path.rsplit("/", 1)[-1]


def topics(root=ROOT):
    """The topics in the order of their gradus_add_topic lines."""
    found = []
    text = (root / "CMakeLists.txt").read_text(encoding="utf-8")
    for call in re.findall(r"^gradus_add_topic\(([^)]*)\)", text, re.MULTILINE):
        path, *rest = call.split()
        names = rest[rest.index("DEPENDS") + 1:] if "DEPENDS" in rest else []
        found.append(Topic(path, tuple(n for n in names if n != "PARTIAL"), "PARTIAL" in rest))
    return found


def stories(root=ROOT):
    """The paths of the gradus_add_story lines: topics of the visualizer alone."""
    return re.findall(r"^gradus_add_story\(([^)\s]+)\)", (root / "CMakeLists.txt").read_text(encoding="utf-8"),
                      re.MULTILINE)


def naming(topic):
    """What names a topic in the command, which knows none. Two words or more are the topic wherever they stand; a single one, as
    light or window, may mean something else, unless a namespace, an example or a word about topics says that it doesn't."""
    if "_" in topic:
        return rf"\b{topic.replace('_', '[_-]')}\b"
    about = r"\b(?:topics?|entry|entries|catalogue|find_entry)\b"
    return rf'\b{topic}::|\bgradus [a-z]+ {topic}(?![\w.])|{about}.*"{topic}"|"{topic}".*{about}'


def gallery():
    """The folder of the gallery that this build has drawn (the test browser/make_gallery); drawn here if it has not."""
    folder = BUILD / "browser/gallery"
    if not (folder / "index.html").is_file():
        run(COMMAND, "figures", "-o", folder, "--quiet", cwd=ROOT)
    return folder


def sources(root, *folders):
    """The C++ files of these folders, sorted."""
    return sorted(f for folder in folders for f in (root / folder).rglob("*")
                  if f.suffix in (".hpp", ".cpp", ".inc", ".faults") and f.is_file())


def without_comments(text):
    """C++ with comments and the contents of strings blanked; lines and columns stay where they are."""
    def blank(match):
        token = match.group(0)
        if token[0] in "\"'":
            return token[0] + " " * (len(token) - 2) + token[0]
        return re.sub(r"[^\n]", " ", token)
    return re.sub(r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\\n])*\"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])*'", blank, text,
                  flags=re.DOTALL)


OBSERVER_CALL = re.compile(r"\bobserver\s*\(")
OBSERVER_LINE = re.compile(r"^ *if constexpr \(observed<\w+>\) observer\(.*\);$")


@dataclass(frozen=True)
class Function:
    """A function of a header, by the lines (from 0) between its braces."""
    name: str
    first: int
    last: int  # one past


def functions(text):
    """The functions of a formatted header: what opens a brace at the end of an unindented declaration."""
    lines = without_comments(text).split("\n")
    found = []
    start = 0  # of the declaration that is being read
    for number, line in enumerate(lines):
        if number < start:
            continue
        if not line.strip() or line.startswith(("}", "#", "namespace", "template")):
            start = number + 1
            continue
        if line.rstrip().endswith("{") and "(" in "".join(lines[start:number + 1]):
            end = next((n for n in range(number + 1, len(lines)) if lines[n].startswith("}")), None)
            declaration = " ".join(lines[start:number + 1])
            name = re.search(r"(\w+)\s*\(", declaration)
            if end is not None and name:
                found.append(Function(name.group(1), number + 1, end))
                start = end + 1
        elif line.rstrip().endswith((";", "}")) and not line.startswith(" "):
            start = number + 1
    return found


def observed_functions(text):
    """The functions that report steps: the methods, which figures may list."""
    lines = without_comments(text).split("\n")
    return [f for f in functions(text) if any(OBSERVER_CALL.search(line) for line in lines[f.first:f.last])]


def topic_headers(topic, root=ROOT):
    """The topic's headers, that of its faults among them, which the build makes."""
    made = [made_header(faults) for faults in (root / "algorithms" / topic.path).glob("*.faults") if root == ROOT]
    return sorted((root / "algorithms" / topic.path).glob("*.hpp")) + made


def without_signs(text):
    """A made header without the signs of what a fault strikes out and puts in."""
    return re.sub(r"(?<=^)( *)//- |  //\+$", r"\1", text, flags=re.MULTILINE)


MADE_HEADERS = BUILD / "generated/algorithms"  # an include root, too


def made_header(faults):
    """What the build makes of a file of faults."""
    folder = faults.parent.relative_to(ROOT / "algorithms")
    return MADE_HEADERS / folder / f"{faults.stem}_notes.hpp"


def precompiled(folder, compiler, *flags, headers=()):
    """Flags for compilations with these flags, that need not read the packages' headers (and these of ours) again:
    those that headers of the algorithms include."""
    found = {name for header in (ROOT / "algorithms").rglob("*.hpp")
             for name in re.findall(r"^#include (<[\w./]+>)", header.read_text(encoding="utf-8"), re.MULTILINE)}
    name = pathlib.Path(folder) / f"precompiled_{len(list(pathlib.Path(folder).glob('precompiled_*.hpp')))}.hpp"
    name.write_text("".join(f"#include {header}\n" for header in [*sorted(h for h in found if not h.startswith("<hwy/")),
                                                                  *(f'"{header}"' for header in headers)]), encoding="utf-8")
    run(compiler, *flags, "-x", "c++-header", name, "-o", f"{name}.gch")
    return ["-include", name]


def compilers():
    """The compiler of the build, and those of the two kinds that are here."""
    found = {}
    for name in (COMPILER, "g++", "clang++-19"):
        path = shutil.which(name)
        if path:
            found.setdefault(os.path.realpath(path), name)
    return list(found.values())


def run(*command, **options):
    """Runs a program; fails with its whole output."""
    done = subprocess.run([str(part) for part in command], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, encoding="utf-8", errors="replace", **options)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, command))}\nexit {done.returncode}\n{done.stdout}")
    return done.stdout


def live_build():
    """The folder in which the module of live pages was built (preset live), brought up to date; None where none was."""
    folder = ROOT / "build/live"
    if not (folder / "gradus.wasm").is_file():
        return None
    with open(folder / "tests.lock", "w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # two tests ask for it
        run("cmake", "--build", folder)
    return folder
