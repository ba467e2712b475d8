#!/usr/bin/env python3
"""Gets axe-core, the accessibility checker of axe_test.py, from the npm registry: one file, without npm.

    get_axe_core.py FOLDER [REGISTRY]

Does nothing where FOLDER/axe.min.js is there.
Exits 1, with one line, when it cannot be had.
"""
import base64
import hashlib
import io
import pathlib
import sys
import tarfile
import urllib.request

PACKAGE, VERSION = "axe-core", "4.14.1"
# As the registry states it; 64 bytes
INTEGRITY = "sha512-FHfa+lmNjQZfJz1q8wKqIDwC6DExcHt/pkjNQb09a3NPjCKg2rhu5qb2S4r76ASyFNNtuFooJpZe37OgudVGtQ=="


def script_in(archive):
    """axe.min.js from the bytes of the package, whose checksum must be right."""
    algorithm, _, digest = INTEGRITY.partition("-")
    if hashlib.new(algorithm, archive).digest() != base64.b64decode(digest):
        raise ValueError(f"its {algorithm} is another one")
    with tarfile.open(fileobj=io.BytesIO(archive)) as package:
        return package.extractfile("package/axe.min.js").read()


def main(folder, registry="https://registry.npmjs.org"):
    target = pathlib.Path(folder) / "axe.min.js"
    if target.is_file():
        return 0
    address = f"{registry}/{PACKAGE}/-/{PACKAGE}-{VERSION}.tgz"
    try:
        with urllib.request.urlopen(address, timeout=60) as answer:
            script = script_in(answer.read())
    except (OSError, ValueError, tarfile.TarError) as error:
        print(f"{PACKAGE} {VERSION} cannot be had from {registry}: {error}", file=sys.stderr)
        return 1
    target.parent.mkdir(parents=True, exist_ok=True)
    written = target.with_suffix(".tmp")
    written.write_bytes(script)
    written.replace(target)
    return 0


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
