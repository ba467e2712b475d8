"""The programs that tests call, and the packages they come from: the one place where they are declared.

A script that imports command, project or webdriver finds only these on its PATH, and so do the GoogleTest programs
(CMakeLists.txt makes their folder with `programs.py FOLDER`). So a test that calls anything else fails wherever it
runs, also on a machine that has it. tests/architecture/programs_test.py checks that ./bootstrap brings what is here.
"""
import atexit
import functools
import os
import pathlib
import shutil
import sys
import tempfile

# Package of ./bootstrap -> its programs, or those of a package that it brings along
PACKAGES = {
    "g++": ("c++", "g++", "as", "ld", "ar", "ranlib"),
    "cmake": ("cmake", "ctest"),
    "ninja-build": ("ninja",),
    "clang-19": ("clang++-19",),
    "lld-19": ("wasm-ld-19",),
    "clang-format-19": ("clang-format-19",),
    "ffmpeg": ("ffmpeg", "ffprobe"),
    "librsvg2-bin": ("rsvg-convert",),
    "poppler-utils": ("pdfinfo", "pdftocairo", "pdftoppm", "pdftotext"),
    "qpdf": ("qpdf",),
    "blahtexml": ("blahtexml",),
    "zsh": ("zsh",),
    "fish": ("fish",),
    "groff-base": ("groff", "troff", "grotty", "preconv"),
    "chromium": ("chromium",),
    "chromium-driver": ("chromedriver",),
    "firefox-esr": ("firefox-esr",),
}
# Package of the smallest Debian -> its programs
BASE = {
    "dash": ("sh",),
    "bash": ("bash",),
    "coreutils": ("basename", "cat", "chmod", "dirname", "expr", "head", "ls", "printf", "readlink", "sleep", "uname"),
    "debianutils": ("which",),
    "dpkg": ("dpkg", "dpkg-query"),
    "apt": ("apt-cache",),
    "grep": ("grep",),
    "sed": ("sed",),
    "util-linux": ("setpriv",),
}
# Python module -> package of ./bootstrap
MODULES = {"jsonschema": "python3-jsonschema"}
# Nothing needs it: with it the sanitizers' reports name functions
OPTIONAL = ("llvm-symbolizer",)
# Targets of the build that scripts run: with the tests, every build has them
TARGETS = ("gradus", "gradus-bench", "gradus-stress")


def programs():
    return [program for packages in (PACKAGES, BASE) for group in packages.values() for program in group]


def make(folder):
    """Fills the folder with links to the programs that are here."""
    for program in (*programs(), *OPTIONAL):
        path, link = shutil.which(program), os.path.join(folder, program)
        if path and not os.path.lexists(link):
            os.symlink(path, link)


@functools.cache
def use_nothing_else():
    """From here on the PATH of this process has the declared programs alone."""
    folder = tempfile.mkdtemp(prefix="gradus_programs_")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    make(folder)
    os.environ["PATH"] = folder


if __name__ == "__main__":
    made = pathlib.Path(sys.argv[1])
    shutil.rmtree(made, ignore_errors=True)
    made.mkdir(parents=True)
    make(made)
