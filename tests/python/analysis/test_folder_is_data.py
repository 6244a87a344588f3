# SPDX-License-Identifier: MIT
"""The user's folder, environment and names are data: no module of theirs is run, no table is broken, and what is written is there first."""
import ast
import json
import os
import pathlib
import signal
import subprocess
import sys
import time

import pandas
import pytest
from conftest import ROOT
from hand_written import refusal, write_run, write_sealed_run, write_set
from in_folder import sealed_text
from trophic import cite, cross_check, pool, runs, writing
from trophic.errors import RunError
from trophic.metrics import Measuring
from trophic.report import analyze
from trophic.words import latex_text

PACKAGE = ROOT / "tools/python/trophic"
VERB = [sys.executable, "-I", "-X", "utf8", PACKAGE / "__main__.py"]
HOSTILE = 'a "b",c\nd\'$<script>\\e%\u2028\x1b[31m'
MODULES = ("html", "random", "numbers", "json", "statistics", "pandas", "trophic")


def called(*words, cwd, env=(), **how):
    return subprocess.run(
        [*VERB, *words], cwd=cwd, env={**os.environ, **dict(env)}, capture_output=True, timeout=100, **how
    )


def with_modules(folder):
    """A folder whose Python files stop what imports them."""
    for name in MODULES:
        (folder / name).mkdir()
        (folder / name / "__init__.py").write_text("raise SystemExit(9)\n")
    (folder / "matplotlibrc").write_bytes(b"backend: nonsense\nlines.linewidth: 50\n\xff")
    return folder


@pytest.mark.parametrize(
    "env",
    [
        {},
        {"LC_ALL": "C"},
        {"LC_ALL": "tr_TR.ISO-8859-9", "COLUMNS": "20", "PYTHONIOENCODING": "utf-16"},
        {"PYTHONHOME": "/nowhere", "PYTHONWARNINGS": "error", "PYTHONOPTIMIZE": "2"},
        {"PYTHONPATH": ".", "PYTHONSTARTUP": "html/__init__.py"},
    ],
)
def test_folder_and_environment_change_nothing(tmp_path, env):
    write_run(with_modules(tmp_path) / "Läufe", rule_table="ı-İ", description={"name": "ı", "sentence": "table `ı-İ`"})
    done = called("cite", "Läufe", cwd=tmp_path, env=env)
    assert (done.returncode, done.stderr) == (0, b"")
    assert done.stdout.decode().startswith("A run of 6000 s on kinematic 1 in trophic unknown (fingerprint aa, seed 1)")
    assert "table `ı-İ`.\n" in done.stdout.decode()


def test_figures_read_no_matplotlibrc_of_the_user(tmp_path):
    pytest.importorskip("matplotlib")
    code = (
        "import sys; sys.path.insert(0, sys.argv[1]); from trophic import plot; plot._import_matplotlib()\n"
        "import matplotlib; print(matplotlib.rcParams['lines.linewidth'], matplotlib.get_backend().lower())"
    )
    env = {**os.environ, "MPLBACKEND": "nonsense", "MATPLOTLIBRC": str(tmp_path / "matplotlibrc")}
    words = [sys.executable, "-I", "-c", code, ROOT / "tools/python"]
    done = subprocess.run(words, cwd=with_modules(tmp_path), env=env, capture_output=True, text=True)
    assert (done.stdout, done.stderr) == ("1.5 agg\n", "")


def test_every_text_has_its_encoding():
    wrong = []
    for path in sorted(PACKAGE.rglob("*.py")):
        for call in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if not isinstance(call, ast.Call):
                continue
            name = getattr(call.func, "attr", getattr(call.func, "id", ""))
            given = {word.arg for word in call.keywords}
            modes = [one.value for one in call.args if isinstance(one, ast.Constant) and isinstance(one.value, str)]
            opens = name == "open" and (call.args or call.keywords) and not any("b" in mode for mode in modes)
            of_system = isinstance(call.func, ast.Attribute) and getattr(call.func.value, "id", "") in (
                "os",
                "webbrowser",
            )
            if (name in ("read_text", "write_text") or opens and not of_system) and "encoding" not in given:
                wrong.append(f"{path.name}:{call.lineno}")
            if name in ("run", "Popen") and {"text", "universal_newlines"} & given:
                wrong.append(f"{path.name}:{call.lineno}")
    assert wrong == []


@pytest.mark.parametrize(
    "name, cell",
    [
        (HOSTILE, '"a ""b"",c\\x0ad\'$<script>\\e%\\xe2\\x80\\xa8\\x1b[31m"'),
        (os.fsdecode(b"\xffx"), "\\udcffx"),
        ("a,b", '"a,b"'),
    ],
)
def test_a_name_breaks_no_table(tmp_path, monkeypatch, capsys, name, cell):
    monkeypatch.chdir(tmp_path)
    write_run(name, origin={"at_s": "1", "run": HOSTILE, "seed": "1", "fingerprint": "aa"})
    request = {"who": "trophic analyze", "runs": [name], "out": "o", "all": True, "html": "page.html", "replays": 0}
    assert analyze.run(request) == 0
    rows = pathlib.Path("o/metrics.csv").read_text(encoding="utf-8").splitlines()
    assert all(row.split(",", 1)[1].startswith(cell + ",1,") for row in rows[1:])
    assert len(pandas.read_csv("o/metrics.csv")) == len(rows) - 1 and len(runs.read_analysis("o").metrics) > 10
    assert json.loads(pathlib.Path("o/summary.json").read_text(encoding="utf-8"))["sets"][0]["runs"][0]["folder"]
    assert cite.run({"who": "trophic cite", "run": name}) == 0
    said = capsys.readouterr()
    assert "\x1b" not in said.out + said.err and "d'$" in said.out
    page = pathlib.Path("page.html").read_text(encoding="utf-8")
    assert "<script>\\e" not in page
    if name == "a,b":
        assert "trophic analyze a,b --html page.html" in page


def test_names_in_latex_and_own_headers():
    assert latex_text("a\n\nb") == "a\\textbackslash{}x0a\\textbackslash{}x0ab"
    assert writing.csv_text(pandas.DataFrame({'a,"b"': ['"', "x\r"], "n": [1.5, None]})) == (
        '"a,""b""",n\n"""",1.5\nx\\x0d,\n'
    )


@pytest.mark.parametrize("value", ["1.7e308", "-1e308", "1.1e60"])
def test_numbers_whose_sums_are_not_finite_are_refused(tmp_path, value):
    run = write_run(tmp_path / "run", files={"own.csv": f"x\n{value}\n{value}\n"})
    why = f'own.csv:2: x = "{value}": must be >= -1e60 and <= 1e60'
    assert refusal(pool.read_set, [run], how=Measuring(jobs=1, columns=["own.csv:x"])).endswith(why)

    def mine(_):
        return float(value)

    how = Measuring(jobs=1, functions=[mine])
    assert refusal(pool.read_set, [run], how=how).endswith("must be >= -1e60 and <= 1e60")


def test_files_are_there_before_the_text(tmp_path):
    write_run(tmp_path / "run")
    with subprocess.Popen(
        [*VERB, "analyze", "run", "--all", "--out", "o"], cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as program:
        program.stdout.close()
        assert program.stderr.read().count(b"Traceback") == 0
    assert program.returncode == -signal.SIGPIPE
    assert sorted(path.name for path in tmp_path.iterdir()) == ["o", "run"] and (tmp_path / "o/summary.json").exists()


def test_analyses_at_once_take_the_next_free_names(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with writing.result_folder(None) as first, writing.result_folder(None) as second:
        assert (first.name, second.name) == ("analysis.part", "analysis-1.part")
        with writing.result_folder(None, name="contests") as other:
            pass
    assert sorted(path.name for path in tmp_path.iterdir()) == ["analysis", "analysis-1", "contests"]
    assert other.with_suffix("").name == "contests"


def test_a_signal_in_the_first_second_is_code_3(tmp_path):
    write_run(tmp_path / "run")
    for delay_s in (0.15, 0.3, 0.45, 0.6):
        words = [*VERB, "analyze", "run", "--out", f"o-{delay_s}"]
        with subprocess.Popen(words, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as program:
            started = time.monotonic() + 10.0
            while (
                time.monotonic() < started
                and b"__main__" not in pathlib.Path(f"/proc/{program.pid}/cmdline").read_bytes()
            ):
                time.sleep(0.001)
            time.sleep(delay_s)
            program.send_signal(signal.SIGINT)
            said = program.stderr.read()
        assert (program.returncode, said) in ((3, b""), (0, said)) and b"Traceback" not in said, (delay_s, said)


@pytest.mark.parametrize(
    "change, why",
    [
        ({"html": "x.pdf"}, "--html x.pdf: must end in .html"),
        ({"runs": [], "compare": ["set", "set"]}, "set/replicate-00: must not be in both of the compared sets"),
        ({"runs": [], "compare": ["set", "link"]}, "link/replicate-00: must not be in both of the compared sets"),
        ({"runs": [], "compare": ["set", "copy"]}, "copy/replicate-00: must not be in both of the compared sets"),
    ],
)
def test_what_cannot_be_meant_is_refused(tmp_path, monkeypatch, change, why):
    monkeypatch.chdir(tmp_path)
    write_set("set", 2, shadow=False, sums=True)
    write_set("copy", 2, shadow=False, sums=True)
    os.symlink("set", "link")
    assert why in refusal(analyze.run, {"who": "trophic analyze", "runs": ["set"], "out": "o", **change})
    assert sorted(os.listdir()) == ["copy", "link", "set"]
    if change.get("compare"):
        assert why in refusal(cross_check.run, {"who": "trophic cross-check", "runs": change["compare"], "out": "o"})


def test_a_large_checkpoint_is_refused_in_little_memory(tmp_path):
    run = write_sealed_run(tmp_path / "run")
    manifest = json.loads((run / "manifest.json").read_text())
    for head, size in ((b"", 1 << 33), (b"trophic checkpoint\n", 1 << 28)):
        (run / "checkpoint.bin").write_bytes(head)
        os.truncate(run / "checkpoint.bin", size)
        code = (
            "import resource, sys; sys.path.insert(0, sys.argv[1]); from trophic import runs, errors\n"
            "resource.setrlimit(resource.RLIMIT_DATA, (1 << 28, 1 << 28))\n"
            "try: runs.verify(sys.argv[2])\nexcept errors.RunError as error: print(error)"
        )
        words = [sys.executable, "-I", "-c", code, ROOT / "tools/python", run]
        done = subprocess.run(
            words, env={**os.environ, "OPENBLAS_NUM_THREADS": "1"}, capture_output=True, text=True, timeout=60
        )
        assert "checkpoint.bin: is cut short or damaged" in done.stdout, done.stderr
    (run / "manifest.json").write_text(sealed_text(manifest))
    os.truncate(run / "manifest.json", 1 << 33)
    with pytest.raises(RunError, match="manifest.json: has 8589934592 bytes: must be <= 268435456"):
        runs.read_run(run)
