"""Lectures for the tests of `gradus figures`: how one is written, and what is made of it."""
import hashlib
import json
import os
import pathlib
import subprocess

from command import GRADUS

ROOT = pathlib.Path(os.environ.get("GRADUS_SOURCE_DIR", pathlib.Path(__file__).resolve().parents[2]))
LINE = {"topic": "bresenham_line", "input": {"from": "0,0", "to": "9,4"}}


def gradus(*words, stdin=b"", cwd=None):
    """Exit code, stdout, stderr."""
    done = subprocess.run([GRADUS, *words], input=stdin, capture_output=True, timeout=300, cwd=cwd)
    return done.returncode, done.stdout.decode(), done.stderr.decode()


def write(path, content):
    pathlib.Path(path).parent.mkdir(parents=True, exist_ok=True)
    text = content if isinstance(content, str) else json.dumps(content)
    pathlib.Path(path).write_text(text, encoding="utf-8")


def figures(*members, **deck):
    """A lecture; a figure is a line, unless it says otherwise."""
    return {**deck, "figures": [{**LINE, **member} for member in members]}


def made(folder):
    """Name -> hash of all files but the manifest, which holds times."""
    return {str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
            for path in sorted(pathlib.Path(folder).rglob("*"))
            if path.is_file() and path.name != ".gradus-manifest.json"}
