"""Writes the skeleton of a topic and names it in the lists that people keep: what `./bootstrap new family/topic` runs.

docs/new_topic holds the skeleton as the files of a topic new_family/new_topic. All that is to be written is made in memory
first, then beside the project, and only then put in place: it is all there or nothing is.
"""
import json
import pathlib
import re
import sys
import tempfile

import lists as all_lists
import project

ROOT = pathlib.Path(__file__).resolve().parents[2]
SKELETON = "docs/new_topic"
PAGE = "docs/adding_a_topic.md"
MARKER = "FILL IN"  # in everything that the skeleton leaves to its author
NAME = r"[a-z][a-z0-9]*(?:_[a-z0-9]+)*"
LONGEST_FAMILY, LONGEST_TOPIC = 24, 32
# Words that can't name a namespace: C++'s own, and namespaces that are used without gradus:: before them
KEYWORDS = set("""alignas alignof and asm auto bitand bitor bool break case catch char class compl concept const consteval
constexpr constinit continue decltype default delete do double else enum explicit export extern false float for friend goto
if inline int long mutable namespace new noexcept not nullptr operator or private protected public register requires return
short signed sizeof static struct switch template this throw true try typedef typeid typename union unsigned using virtual
void volatile while xor boost fmt glm hwy main std testing""".split())


class Refusal(Exception):
    """What was asked for can't be: one line that says why."""


# --- Names -----------------------------------------------------------------------------------------------------------


def family_and_topic(words):
    """The two names that the command was given."""
    found = repr(" ".join(words)) if words else "nothing"
    match = re.fullmatch(f"({NAME})/({NAME})", words[0]) if len(words) == 1 else None
    if not match:
        raise Refusal(f"expected family/topic, such as clipping/liang_barsky, in small letters, digits and _; found {found}")
    family, topic = match.groups()
    if len(family) > LONGEST_FAMILY or len(topic) > LONGEST_TOPIC:
        raise Refusal(f"expected at most {LONGEST_FAMILY} letters for the family and {LONGEST_TOPIC} for the topic, found {found}")
    return family, topic


def folders(root, *parts):
    return {folder.name for part in parts for folder in (root / part).glob("*/")}


def declarations(text, name):
    """The namespaces in which a file of C++ declares this name, each with whether it is one that `name::` can speak of."""
    declaration = re.compile(rf"(?:(?P<scope>namespace |using )(?P<outer>(?:\w+::)*)|(?![/ ])[\w:<>,&* \[\]]+ ){name}\b *[({{:;=]")
    inside = []
    for line in text.split("\n"):
        declared, opened = declaration.match(line), re.match(r"(?:inline )?namespace(?: ([\w:]+))? {", line)
        if declared:
            outer = (declared["outer"] or "").removesuffix("::")
            yield "::".join(filter(None, [*inside, outer])), declared["scope"] is not None
        if opened:
            inside.append(opened[1])
        elif line.startswith("}  // namespace"):
            inside.pop()


def place_of(root, name):
    """The file in which a topic of this name would meet another meaning of it. gradus::name is the topic's alone, as is the function
    of its name that its promises and its benchmark define; what has a namespace or a type for itself lies behind `name::` there. And
    the command names no topic."""
    in_command = re.compile(project.naming(name))
    for file in project.sources(root, "algorithms/core", "visualize", "pipeline", "tests/stress", "tests/benchmark", "tests/support"):
        text = file.read_text(encoding="utf-8")
        for space, is_scope in declarations(text, name) if name in text else ():
            if space == "gradus" or file.suffix == ".hpp" and (is_scope or space in ("gradus::bench", "gradus::stress")):
                return file.relative_to(root).as_posix()
        if file.is_relative_to(root / "visualize/cli") and in_command.search(text):
            return file.relative_to(root).as_posix()
    return None


def commands(root):
    """What the command line takes where a topic could stand, too."""
    table = (root / "visualize/cli/commands/commands.cpp").read_text(encoding="utf-8")
    return set(re.findall(r'^ {6}\{"([a-z-]+)",$', table, re.MULTILINE))


def sections(root):
    """What the texts of figures speak of besides topics."""
    files = [root / "visualize/figure/language/en.txt", *(root / "visualize/stories").rglob("*.en.txt")]
    return {name for file in files for name in re.findall(r"^\[(\w+)", file.read_text(encoding="utf-8"), re.MULTILINE)}


def targets(root):
    """What the build calls its parts: the words behind gradus:: and gradus_."""
    files = [file for pattern in ("CMakeLists.txt", "tests/CMakeLists.txt", "algorithms/*.cmake", "visualize/*.cmake")
             for file in root.glob(pattern)]
    return {name for file in files for name in re.findall(r"\bgradus(?:::|_)(\w+)", file.read_text(encoding="utf-8"))}


def check_names(root, family, topic):
    for path in (*(known.path for known in project.topics(root)), *project.stories(root)):
        if path.split("/")[1] == topic:
            raise Refusal(f"there is a topic {path} already")
    parts = folders(root, ".", "visualize", "pipeline", "tests") | KEYWORDS
    if family in parts | {"core"}:
        raise Refusal(f"'{family}' can't be a family: it is a folder of the project or a word of C++")
    if topic in parts | targets(root) | sections(root):
        raise Refusal(f"'{topic}' can't be a topic: it is a part of the project or a word of C++")
    if topic in commands(root):
        raise Refusal(f"'{topic}' can't be a topic: it is a command")
    place = place_of(root, topic)
    if place:
        raise Refusal(f"'{topic}' can't be a topic: {place} uses that name")


# --- The topic's own files -------------------------------------------------------------------------------------------


def suite_of(topic):
    """What the topic's tests are called: BresenhamLine."""
    return "".join(word.capitalize() for word in topic.split("_"))


def names_of(family, topic):
    """What the skeleton calls its names -> what they are called here."""
    title = topic.replace("_", " ")
    return {"new_family": family, "new_topic": topic, "NewTopic": suite_of(topic), "New topic": title.capitalize()}


def filled(text, names):
    return re.sub("|".join(names), lambda found: names[found[0]], text)


def own_files(root, family, topic):
    """Path -> text of every file that belongs to the topic alone."""
    names = names_of(family, topic)
    skeleton = root / SKELETON
    return {filled(file.relative_to(skeleton).as_posix(), names): filled(file.read_text(encoding="utf-8"), names)
            for file in sorted(skeleton.rglob("*")) if file.is_file()}


# --- The lists that name all topics ----------------------------------------------------------------------------------


def after_last(text, patterns, addition):
    """The text with an addition behind the last place where the first pattern that is there at all ends."""
    for pattern in patterns:
        found = list(re.finditer(pattern, text, re.MULTILINE))
        if found:
            return text[:found[-1].end()] + addition + text[found[-1].end():]
    raise Refusal(f"no place was found for {addition.strip()!r}")


def in_cmake(text, family, topic):
    return after_last(text, [rf"^gradus_add_topic\({family}/.*\)\n", r"^gradus_add_topic\(.*\)\n"],
                      f"gradus_add_topic({family}/{topic})\n")


def placed(called, family, path, title):
    """The topics' titles with one more, behind the last one of its family."""
    same = [index for index, known in enumerate(called, 1) if known.startswith(family + "/")]
    pairs = list(called.items())
    pairs.insert(same[-1] if same else len(pairs), (path, title))
    return dict(pairs)


def in_gallery(text, family, topic, topics):
    figures = json.loads(text)["figures"]
    known = {other.name: other.path.split("/")[0] for other in topics}
    last = [figure["name"] for figure in figures if known.get(figure["topic"]) == family] or [figures[-1]["name"]]
    entry = (f'\n    {{\n      "name": "{topic}",\n      "topic": "{topic}",\n      "input": {{"columns": 5, "rows": 2}},\n'
             f'      "caption": "{MARKER}: what the figure shows, in a sentence."\n    }}')
    place = re.search(rf'^    {{\n      "name": "{last[-1]}",\n(?:      .*\n)*    }}', text, re.MULTILINE)
    return f"{text[:place.end()]},{entry}{text[place.end():]}"


def in_coverage(text, topic):
    return f"{text}{MARKER} an id,\"{MARKER}: what the topic promises to show.\",test,{suite_of(topic)}.IsToBeFilledIn\n"


def lists(root, family, topic):
    """Path -> text of every list with the topic in it."""
    topics = project.topics(root)
    def changed(path, change, *more):
        return path, change((root / path).read_text(encoding="utf-8"), *more)
    called = placed(all_lists.titles(root), family, f"{family}/{topic}", names_of(family, topic)["New topic"])
    return dict([
        *all_lists.with_links(root, called).items(),
        changed("CMakeLists.txt", in_cmake, family, topic),
        changed("docs/coverage.csv", in_coverage, topic),
        changed("examples/gallery.json", in_gallery, family, topic, topics)])


# --- Putting it all in place -----------------------------------------------------------------------------------------


def put(root, new, changed):
    """Writes new files, and lists over what they are; what goes wrong on the way undoes what was done."""
    for path in new:
        if (root / path).exists():
            raise Refusal(f"{path} is there already; nothing was written")
    made, before = [], {}  # files and folders in this order, and what stood in the lists
    try:
        with tempfile.TemporaryDirectory(prefix=".new_topic_", dir=root) as name:
            staged = [pathlib.Path(name) / str(number) for number in range(len(new) + len(changed))]
            for file, text in zip(staged, [*new.values(), *changed.values()]):
                file.write_text(text, encoding="utf-8")
            for file, target in zip(staged, (root / path for path in new)):
                for folder in reversed(target.parents):
                    if not folder.exists():
                        folder.mkdir()
                        made.append(folder)
                file.rename(target)
                made.append(target)
            for file, target in zip(staged[len(new):], (root / path for path in changed)):
                before[target] = target.read_bytes()
                file.chmod(target.stat().st_mode)
                file.replace(target)
    except BaseException as error:
        for path in reversed(made):
            path.rmdir() if path.is_dir() else path.unlink()
        for path, content in before.items():
            path.write_bytes(content)
        if not isinstance(error, OSError):
            raise
        place = error.filename2 or error.filename  # of a file that can't be put there, where to
        raise Refusal(f"{place}: {error.strerror}; nothing was written") from error


def write(root, words):
    """Makes the topic that the words name; returns what there is to say of it."""
    family, topic = family_and_topic(words)
    check_names(root, family, topic)
    is_new = family not in folders(root, "algorithms")
    new, changed = own_files(root, family, topic), lists(root, family, topic)
    put(root, new, changed)
    return [*new, "named in " + ", ".join(changed),
            (f"{family} is a new family. " if is_new else "") +
            f"Tests fail until no '{MARKER}' is left: {PAGE} goes through the files."]


if __name__ == "__main__":
    try:
        print("\n".join(write(ROOT, sys.argv[1:])))
    except Refusal as refusal:
        print(f"bootstrap new: {refusal}", file=sys.stderr)
        sys.exit(2)
