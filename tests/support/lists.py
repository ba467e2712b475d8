"""Writes what documents list of all topics, from the topics themselves: what `./bootstrap lists` runs once the command is built.

A list stands between <!-- NAME: ./bootstrap lists --> and <!-- NAME ends -->; the rest of a document is its author's. The test
architecture/topics holds each list to what this would write.
"""
import re
import sys

import project

FAMILIES = {"visibility": "hidden surfaces", "antialiasing": "aliasing and antialiasing"}  # those not called by their folder


def titles(root):
    """Path of each topic that is told -> what its page is called."""
    found = {}
    for topic in project.topics(root):
        if not topic.partial:
            page = (root / f"docs/topics/{topic.path}.md").read_text(encoding="utf-8")
            found[topic.path] = re.match(r"# (.+)\n", page)[1]
    return found


def links(called, folder, anchor="", indent=""):
    """A line for each family, with a link to the page of each of its topics."""
    families = {}
    for path, title in called.items():
        families.setdefault(path.split("/")[0], []).append(f"[{title}]({folder}{path}.md{anchor})")
    lines = []
    for family, its in families.items():
        lines.append(f"{indent}- {FAMILIES.get(family, family.replace('_', ' '))}: {', '.join(its)}")
    return "\n".join(lines)


def promises():
    """A row for each topic: what it promises, as the command says."""
    rows, count = [], 0
    said = project.run(project.COMMAND, "stress", "--list")
    for part in re.split(r"^(?=\S)", said, flags=re.MULTILINE)[1:]:
        topic, *its = part.splitlines()
        count += len(its)
        kept = "; ".join(re.sub(r"^  (\w+) +", r"`\1`: ", line.replace("`", "")).replace("|", r"\|") for line in its)
        rows.append(f"| `{topic}` | {kept} |")
    head = f"{count} promises of {len(rows)} topics and parts:\n\n| topic | promises |\n|---|---|\n"
    return head + "\n".join(rows)


# Where topics are linked to: document, name of the list -> how links are written there
LINKS = {("README.md", "topics"): {"folder": "docs/topics/"},
         ("docs/README.md", "topics"): {"folder": "topics/", "indent": "  "},
         ("docs/benchmarks.md", "charts"): {"folder": "topics/", "anchor": "#charts"}}
PROMISES = ("docs/stress.md", "promises")


def with_list(text, name, lines):
    """The text with these lines as its list of that name."""
    found = re.search(rf"(?s)(.*<!-- {name}: \./bootstrap lists -->\n)(.*?)(\n<!-- {name} ends -->.*)", text)
    return found[1] + lines + found[3]


def with_links(root, called):
    """Path -> text of each document that links to all topics, were these all there are."""
    return {path: with_list((root / path).read_text(encoding="utf-8"), name, links(called, **how))
            for (path, name), how in LINKS.items()}


def out_of_date(root):
    """Path -> text of each document whose list is not what it would be now."""
    path, name = PROMISES
    texts = with_links(root, titles(root))
    texts[path] = with_list((root / path).read_text(encoding="utf-8"), name, promises())
    return {path: text for path, text in texts.items() if text != (root / path).read_text(encoding="utf-8")}


if __name__ == "__main__":
    changed = out_of_date(project.ROOT)
    for path, text in changed.items():
        (project.ROOT / path).write_text(text, encoding="utf-8")
    print("\n".join(changed) or "all lists are as they should be", file=sys.stderr)
