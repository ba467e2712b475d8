"""What the tests of the `gradus` command share: where it is, what has passed and failed, a folder for each test."""
import os
import shutil
import subprocess
import sys
import tempfile
import time

import programs

programs.use_nothing_else()
GRADUS = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else os.environ.get("GRADUS_COMMAND", "gradus"))
PLAIN = {k: v for k, v in os.environ.items()
         if k not in ("NO_COLOR", "CLICOLOR_FORCE", "FORCE_COLOR", "COLUMNS", "SLURM_CPUS_PER_TASK")}

passed = failed = 0


def check(truth, what):
    global passed, failed
    if truth:
        passed += 1
    else:
        failed += 1
        print("FAILED:", what)
    return bool(truth)


def equal(found, expected, what):
    return check(found == expected, f"{what}\n    expected: {expected!r}\n    found:    {found!r}")


class Result:
    def __init__(self, process):
        self.code = process.returncode
        self.bytes = process.stdout or b""
        self.out = self.bytes.decode("utf-8", "replace")
        self.err = (process.stderr or b"").decode("utf-8", "replace")


def gradus(*words, stdin=b"", env=None, timeout=300, **options):
    options.setdefault("stdout", subprocess.PIPE)
    process = subprocess.run([GRADUS, *words], input=stdin, stderr=subprocess.PIPE, timeout=timeout,
                             env={**PLAIN, **(env or {})}, **options)
    return Result(process)


def in_new_folder(test):
    """Every test has an empty folder of its own as the current one."""
    folder = tempfile.mkdtemp(prefix="gradus_test_")
    os.chdir(folder)
    try:
        test()
    except Exception as error:  # one broken test must not hide the others
        check(False, f"{test.__name__}: {type(error).__name__}: {error}")
    finally:
        os.chdir("/")
        subprocess.run(["chmod", "-R", "u+rwx", folder], check=False)
        shutil.rmtree(folder, ignore_errors=True)


def tests_of(names):
    """The functions test_… among the names of a script."""
    return [value for name, value in names.items() if name.startswith("test_")]


def summary():
    """What has passed; the exit code. A run without a single check has failed."""
    print(f"{passed} passed, {failed} failed")
    return 1 if failed or not passed else 0


def run_all(names):
    for test in tests_of(names):
        start = time.monotonic()
        in_new_folder(test)
        print(f"{time.monotonic() - start:6.1f} s  {test.__name__}", flush=True)
    return summary()
