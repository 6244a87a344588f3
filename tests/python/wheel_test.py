#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""wheel_test.py SOURCES BUILD PREDATOR_PREY: a wheel of the programs in a build folder, installed into an environment of its own, runs, steps,
analyses and shows without a path that anyone sets; its runs have the bytes of the build's program. The syntax is that of Python 3.9.

Exit code 77, skipped, without scikit-build-core, which comes from PyPI."""

import ast
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile

SOURCES, BUILD, PREDATOR_PREY = (pathlib.Path(sys.argv.pop(1)).absolute() for _ in range(3))
sys.path.insert(0, str(SOURCES / "tests/program"))
from in_folder import InFolder, call, run_ok  # noqa: E402

RUN = ("--backend", "kinematic", "--duration", 60, "--seed", 3, "--out")
STEPS = """
import trophic_ecologies
ecology = trophic_ecologies.Ecology({"rule_table": "paper", "engine": "kinematic", "seed": 3, "ecology.duration_s": 60})
ecology.reset(out="stepped")
while ecology.sense():
    ecology.decide(ecology.own_outputs())
ecology.close()
"""


def tools() -> pathlib.Path:
    """A folder with scikit-build-core."""
    folder = pathlib.Path(tempfile.mkdtemp(prefix="trophic-wheel-"))
    unittest.addModuleCleanup(shutil.rmtree, folder)
    words = [
        sys.executable,
        "-m",
        "pip",
        "install",
        "-q",
        "--retries",
        1,
        "--timeout",
        10,
        "--target",
        folder,
        "scikit-build-core",
    ]
    try:
        done = call(*words, timeout=60)
        why = done.stderr.strip().splitlines()[-1:] if done.returncode else None
    except subprocess.TimeoutExpired:
        why = ["PyPI does not answer"]
    if why is not None:
        print(f"needs scikit-build-core: {''.join(why)}")
        sys.exit(77)
    return folder


class Wheel(InFolder):
    @classmethod
    def setUpClass(cls):
        cls.place = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.settings = {"cmake.source-dir": "packaging/wheel", "cmake.define.TROPHIC_BUILT": BUILD}
        pip = [sys.executable, "-m", "pip", "-q"]
        run_ok(
            *(*pip, "wheel", "--no-deps", "--no-build-isolation", "--no-index", "-w", cls.place, SOURCES),
            *(word for key, value in cls.settings.items() for word in ("--config-settings", f"{key}={value}")),
            env={**os.environ, "PYTHONPATH": str(TOOLS)},
            cwd=cls.place,
        )
        (cls.wheel,) = cls.place.glob("trophic-*.whl")
        run_ok(sys.executable, "-m", "venv", "--system-site-packages", "--without-pip", cls.place / "env")
        cls.bin = cls.place / "env/bin"
        run_ok(*pip, "--python", cls.bin / "python", "install", "--no-deps", "--no-index", cls.wheel)
        cls.site = next((cls.place / "env/lib").glob("python*/site-packages"))

    def in_environment(self, *words):
        """What a program of the environment prints, in a shell that knows nothing of trophic."""
        return self.run_ok(self.bin / words[0], *words[1:], env={"PATH": "/usr/bin:/bin", "HOME": str(self.folder)})

    def assert_same(self, one, other, *more):
        tables = sorted(path.name for path in (self.folder / other).glob("*.csv"))
        self.assertEqual(tables, ["agents.csv", "events.csv", "genomes.csv", "phylogeny.csv"])
        for name in (*tables, *more):
            self.assertEqual(*((self.folder / run / name).read_bytes() for run in (one, other)), name)

    def test_it_has_package_programs_models_and_no_name_of_the_sources(self):
        with zipfile.ZipFile(self.wheel) as archive:
            names = set(archive.namelist())
            metadata = next(archive.read(name).decode() for name in names if name.endswith("METADATA"))
            for name in names:
                self.assertNotRegex(
                    archive.read(name), rb"(?<![\w.-])" + re.escape(bytes(SOURCES)) + rb"(?![\w.-])", name
                )
        package = SOURCES / "tools/python"
        kinds = ("*.py", "*.pyi", "*.j2", "py.typed")
        files = {str(path.relative_to(package)) for kind in kinds for path in package.rglob(kind)}
        models = {
            f"trophic/compiled/share/trophic/{path.relative_to(SOURCES)}"
            for path in (SOURCES / "models").rglob("*.toml")
        }
        self.assertLess(files | models, names)
        self.assertEqual(
            {name for name in names if name.endswith(".py")}, {name for name in files if name.endswith(".py")}
        )
        for program in ("trophic", "trophic-predator-prey", "trophic-worlds", "trophic-analyze"):
            self.assertIn(f"trophic/compiled/kinematic/{program}", names)
        self.assertIn("Requires-Python: >=3.9", metadata)

    def test_its_runs_have_the_bytes_of_the_build(self):
        self.in_environment("trophic-predator-prey", *RUN, "its")
        self.run_ok(PREDATOR_PREY, *RUN, "ours")
        self.assert_same("its", "ours", "replay.trp")
        self.assertIn("rule table `paper`", self.in_environment("trophic", "cite", "its").stdout)

    def test_the_python_of_readme(self):
        blocks = re.findall(r"```python\n(.*?)```", (SOURCES / "README.md").read_text(), re.DOTALL)
        self.assertTrue(blocks)
        environment = {"PATH": "/usr/bin:/bin", "HOME": str(self.folder)}
        missing = []
        for block in blocks:
            code = f"{block}\nimport trophic; print(trophic.__file__)"
            done = self.call(self.bin / "python", "-c", code, env=environment)
            if lacking := re.search(r"No module named '(?!trophic)\w+'", done.stderr):
                missing.append(lacking[0])
                continue
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(str(self.site), done.stdout)
        if len(missing) == len(blocks):
            self.skipTest(missing[0])
        for page in re.findall(r'"([\w-]+\.html)"', "".join(blocks)):
            self.assertGreater((self.folder / page).stat().st_size, 100_000)

    def test_python_steps(self):
        if not list((BUILD / "wheel/kinematic").glob("trophic_ecologies.*")):
            self.skipTest("the module is not built")
        self.in_environment("python", "-c", STEPS)
        self.run_ok(PREDATOR_PREY, *RUN, "ours")
        self.assert_same("stepped", "ours")

    def test_an_engine_that_is_not_installed_is_named_with_what_installs_it(self):
        refused = self.call(self.bin / "trophic-predator-prey", "--out", "run", env={"PATH": "/usr/bin:/bin"})
        self.assert_refused(
            refused, '--backend mujoco: this program was built without it; run pip install "trophic[mujoco]"'
        )

    def test_the_programs_with_mujoco_run_if_their_mujoco_is_there(self):
        code = "import trophic.programs; print(trophic.programs.find_program('trophic'))"
        its, library = (self.site / path for path in ("trophic/compiled/mujoco-9.1.0", "mujoco/libmujoco.so.9.1.0"))
        shutil.copytree(its.with_name("kinematic"), its)
        self.addCleanup(shutil.rmtree, its)
        self.assertIn("compiled/kinematic/trophic", self.in_environment("python", "-c", code).stdout)
        library.parent.mkdir()
        self.addCleanup(shutil.rmtree, library.parent)
        library.touch()
        self.assertIn("compiled/mujoco-9.1.0/trophic", self.in_environment("python", "-c", code).stdout)


class Syntax(unittest.TestCase):
    def test_it_is_that_of_python_3_9(self):
        for path in (SOURCES / "tools/python/trophic").rglob("*.py"):
            tree = ast.parse(path.read_text(), feature_version=(3, 9))
            # Annotations such as str | None are not evaluated.
            first = next(
                (node for node in tree.body if isinstance(node, ast.ImportFrom) or not isinstance(node, ast.Expr)), None
            )
            if any(isinstance(node, (ast.FunctionDef, ast.AnnAssign)) for node in ast.walk(tree)):
                if path.parent.name != "figures" or "from __future__" in path.read_text():
                    self.assertEqual(getattr(first, "module", None), "__future__", path)


if __name__ == "__main__":
    TOOLS = tools()
    unittest.main()
