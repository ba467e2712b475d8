#!/usr/bin/env python3
"""Where outputs go: links that lead two of them to one file, limits of the system, folders that can't be made or written.

    tests/golden/outputs_test.py [GRADUS]
"""
import ctypes
import os
import pathlib
import resource
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import command
from command import check, equal, files, gradus, read, write

LINE = ["figure", "bresenham_line", "-q"]
LIBC = ctypes.CDLL(None, use_errno=True)
PR_CAPBSET_DROP, CAP_DAC_OVERRIDE, CAP_DAC_READ_SEARCH = 24, 1, 2  # prctl(2), capabilities(7)
SHEET = ["worksheet", "bresenham_line", "-q", "-o", "sheet.pdf"]


def test_a_key_never_takes_the_place_of_its_sheet():
    os.symlink("sheet.pdf", "ln.pdf")
    os.mkdir("d")
    os.symlink("d", "d2")
    os.symlink("../d/s.pdf", "d/around.pdf")
    for sheet, key in (("sheet.pdf", "ln.pdf"), ("ln.pdf", "./sheet.pdf"), ("d/s.pdf", "d2/s.pdf"), ("d2/s.pdf", "d/around.pdf")):
        result = gradus("worksheet", "bresenham_line", "-o", sheet, "--key", key)
        equal((result.code, result.err), (2, f"gradus: --key: expected another file than -o, found '{key}'\n"), f"{sheet}, {key}")
    equal([name for name in files() if not os.path.islink(name)], [], "nothing is made")


def test_no_file_of_a_series_takes_the_place_of_another():
    os.symlink("a-1.svg", "a-2.svg")
    result = gradus(*LINE, "-o", "a-{step}.svg")
    equal((result.code, result.err),
          (2, "gradus: -o: expected different files, found 'a-2.svg', which leads to another's place\n"), "steps 1 and 2")
    equal(files(), ["a-2.svg"], "nothing is made")


def test_a_file_larger_than_the_system_allows():
    def small_files():
        resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))
    for ending in ("svg", "png", "pdf", "html"):
        result = gradus(*LINE, "-o", f"a.{ending}", preexec_fn=small_files)
        equal((result.code, result.err), (1, f"gradus: can't write 'a.{ending}': File too large\n"), ending)
    equal(files(), [], "no temporary file is left")


def as_anybody():
    """Root may read and write everything; without these capabilities it is held to what files' modes say, as all others
    are. Another user could not run a command that lies in root's home."""
    if os.geteuid() == 0:
        for capability in (CAP_DAC_OVERRIDE, CAP_DAC_READ_SEARCH):
            if LIBC.prctl(PR_CAPBSET_DROP, capability, 0, 0, 0) != 0:
                raise OSError(ctypes.get_errno(), "prctl")


def test_what_the_system_forbids_is_said_before_the_work():
    os.chmod(".", 0o755)
    os.mkdir("locked", 0o555)
    for name in ("a.svg", "a.gif", "a.pdf"):
        result = gradus(*LINE, "-o", f"locked/{name}", preexec_fn=as_anybody)
        equal((result.code, result.err), (1, f"gradus: can't write 'locked/{name}': Permission denied\n"), name)
    result = gradus("demo", "forward", "--frames", "locked/new", preexec_fn=as_anybody)
    equal((result.code, result.err),
          (2, "gradus: --frames: expected a folder that can be made, found 'locked/new' (Permission denied)\n"), "a folder")


def test_a_file_of_ours_that_cannot_be_read():
    os.chmod(".", 0o777)
    gradus(*LINE, "-o", "a.svg")
    os.chmod("a.svg", 0)
    before = os.stat("a.svg").st_mtime_ns
    result = gradus(*LINE, "-o", "a.svg", preexec_fn=as_anybody)
    equal((result.code, result.err),
          (2, "gradus: -o: expected a file that can be read, to see whether gradus made it, found 'a.svg' "
              "(Permission denied; --force replaces it)\n"), "who made it is not known")
    equal(os.stat("a.svg").st_mtime_ns, before, "it stays")


if __name__ == "__main__":
    sys.exit(command.run_all(globals()))
