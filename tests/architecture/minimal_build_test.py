#!/usr/bin/env python3
"""With GRADUS_VISUALIZE=OFF a compiler, GLM and fmt are enough: nothing else is looked for."""
import os
import pathlib
import re
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import project
import share

OTHERS = ("PNG", "ZLIB", "Boost", "hwy", "TBB", "PkgConfig", "CLI11", "nlohmann_json", "Threads", "GTest", "benchmark", "Python3")


class MinimalBuild(unittest.TestCase):
    @staticmethod
    def is_built(topic):
        """Whether more than headers belongs to it."""
        return any("hwy/" not in path.read_text(encoding="utf-8") for path in (project.ROOT / "algorithms").glob(f"*/{topic}/{topic}_batch.cpp"))

    def test_topics_build_with_glm_and_fmt_only(self):
        with tempfile.TemporaryDirectory() as folder:
            environment = dict(os.environ, PKG_CONFIG="/bin/false", PKG_CONFIG_LIBDIR="/nowhere")
            project.run("cmake", "-S", project.ROOT, "-B", folder, "-G", "Ninja", "-DGRADUS_VISUALIZE=OFF",
                        "-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_CXX_FLAGS_DEBUG=", "-DGRADUS_UNITY=ON", f"-DCMAKE_CXX_COMPILER={project.COMPILER}",
                        *(f"-DCMAKE_DISABLE_FIND_PACKAGE_{package}=ON" for package in OTHERS), env=environment)
            cache = pathlib.Path(folder, "CMakeCache.txt").read_text(encoding="utf-8")
            packages = set(re.findall(r"^(\w+)_DIR:PATH=", cache, re.MULTILINE))
            # CMake's own entries apart, these are the packages somebody has looked for
            packages = {p for p in packages if not p.startswith(("CMAKE_", "gradus_"))}
            self.assertEqual(packages, {"glm", "fmt"})
            # The module of live pages builds the pipeline without those packages in each run
            topics = sorted({topic.name for topic in project.topics()})
            some = [] if share.in_share(0, 3) else ["--target", "gradus_core", *(f"gradus_{name}" for name in topics if self.is_built(name))]
            project.run("cmake", "--build", folder, *some)
            # Headers of core and of the topics have their checks here, too, which the whole build runs
            checked = {f.name for f in pathlib.Path(folder, "headers_alone").glob("*.cpp")}
            for topic in project.topics():
                self.assertIn(f"{topic.path}/{topic.name}.hpp".replace("/", "_").replace(".", "_") + ".cpp", checked)


if __name__ == "__main__":
    unittest.main()
