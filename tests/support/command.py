"""What the tests of the `gradus` command share: where it is, what has passed and failed, a folder for each test."""
import os
import pty
import select
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import zlib

import programs

programs.use_nothing_else()
GRADUS = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else os.environ.get("GRADUS_COMMAND", "gradus"))
PLAIN = {k: v for k, v in os.environ.items()
         if k not in ("NO_COLOR", "CLICOLOR_FORCE", "FORCE_COLOR", "COLUMNS", "SLURM_CPUS_PER_TASK")}
INT32 = "-2147483648 to 2147483647"  # the range of whole numbers, as help and complaints say it

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


def files(folder="."):
    return sorted(os.path.relpath(os.path.join(at, name), folder) for at, _, names in os.walk(folder) for name in names)


def read(path):
    with open(path, "rb") as file:
        return file.read()


def write(path, data):
    with open(path, "wb") as file:
        file.write(data if isinstance(data, bytes) else data.encode())


def png(width, height, gray):
    def chunk(kind, data):
        return len(data).to_bytes(4, "big") + kind + data + zlib.crc32(kind + data).to_bytes(4, "big")
    rows = b"".join(b"\0" + bytes(gray(x, y) for x in range(width)) for y in range(height))
    header = width.to_bytes(4, "big") + height.to_bytes(4, "big") + bytes([8, 0, 0, 0, 0])
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def on_terminal(*words, env=None, stdin=subprocess.DEVNULL, enough=None):
    """Output of a run whose stdout and stderr are a terminal, and its exit code. As soon as enough(output) holds, the run
    is interrupted, as by Ctrl-C."""
    main, terminal = pty.openpty()
    process = subprocess.Popen([GRADUS, *words], stdin=stdin, stdout=terminal, stderr=terminal,
                               env={**PLAIN, "TERM": "xterm", **(env or {})})
    os.close(terminal)
    seen = b""
    while True:
        ready, _, _ = select.select([main], [], [], 60)
        try:
            block = os.read(main, 65536) if ready else b""
        except OSError:
            block = b""
        if not block:
            break
        seen += block
        if enough and enough(seen.decode("utf-8", "replace")):
            process.send_signal(signal.SIGINT)
            enough = None
    os.close(main)
    return seen.decode("utf-8", "replace"), process.wait()


def wait_for(condition, seconds=60):
    """Until it holds; after giving up, the caller's next check says so."""
    end = time.monotonic() + seconds
    while not condition() and time.monotonic() < end:
        time.sleep(0.01)


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
