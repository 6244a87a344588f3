# SPDX-License-Identifier: MIT
"""Metrics of one's own: columns of tables, and Python functions of a run."""
import math
import pathlib

import numpy
import pandas
import pytest
from hand_written import refusal, robot, write_run, write_set
from trophic import pool
from trophic.metrics import Measuring, metric, own
from trophic.runs import RunError

NAN = math.nan


@pytest.fixture(autouse=True)
def in_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def measured(run="run", **how):
    """The own values of a run by species and group, the points of their curves, and the remarks."""
    (of,) = pool.read_set([run], how=Measuring(jobs=1, **how)).values
    name = how["columns"][0].split(":")[1] if "columns" in how else own.own_metric(how["functions"][0]).name
    values, curves = of.values[of.values.metric == name], of.curves[of.curves.metric == name]
    return dict(zip(zip(values.species, values.group), values.value)), curves.value.tolist(), of.remarks


@pytest.mark.parametrize("text, unit", [("crowd.csv:close", "1"), ("crowd.csv:close:robots", "robots")])
def test_a_column_is_named_with_or_without_a_unit(text, unit):
    assert own.own_column(text) == ("crowd.csv", "close", unit)


@pytest.mark.parametrize(
    "text",
    ["crowd.csv", "crowd.csv:", "crowd.csv:a:", "crowd.csv:a:b:c", ":close", "../crowd.csv:close", "a/b.csv:close"],
)
def test_a_column_that_is_not_named_so_is_refused(text):
    with pytest.raises(RunError, match=f"^--column {text}: must "):
        own.own_column(text)


@pytest.mark.parametrize(
    "table, until_s, values, curve",
    [
        ("time_s,x\n0,1\n100,3\n200,nan\n300,\n400,8\n", None, {("", "all"): 4.0}, [2.0, 8.0]),
        ("time_s,x\n0,1\n100,3\n400,8\n", 100.0, {("", "all"): 2.0}, [2.0]),
        (
            "species,group,x\nprey,all,1\npredator,all,2\nprey,all,3\n",
            None,
            {("prey", "all"): 2.0, ("predator", "all"): 2.0},
            [],
        ),
        ("x,group\n1,b\n2,a\n3,b\n", None, {("", "b"): 2.0, ("", "a"): 2.0}, []),
    ],
)
def test_a_column_is_its_means_and_curves(table, until_s, values, curve):
    write_run("run", result={"reached_s": 6000.0}, files={"own.csv": table})
    assert measured(columns=["own.csv:x"], until_s=until_s)[:2] == (values, curve)


@pytest.mark.parametrize(
    "table, why",
    [
        ("y\n1\n", 'run/own.csv:1: no column "x"; another kind of file?'),
        ("x\n1\nmany\n", 'run/own.csv:3: x = "many": must be a number'),
        ("x\ninf\n", 'run/own.csv:2: x = "inf": must be finite'),
        ("time_s,x\nnan,1\n", 'run/own.csv:2: time_s = "nan": must be finite'),
        ("x,y\n1\n", "run/own.csv:2: 1 cells, the header has 2"),
        ("species,x\n" + "".join(f"s{i},1\n" for i in range(1001)), "--column own.csv:x: must cover at most 1000"),
    ],
)
def test_a_cell_that_cannot_be_is_refused_by_file_and_line(table, why):
    write_run("run", files={"own.csv": table})
    assert refusal(measured, columns=["own.csv:x"]).startswith(why)


def test_a_run_without_any_value_gets_a_remark_and_a_table_of_the_run_may_not_be_changed():
    write_run("run", files={"own.csv": "x\nnan\nNA\n"}, sums=True)
    values, _, remarks = measured(columns=["own.csv:x"])
    assert math.isnan(values["", "all"]) and remarks == ["run/own.csv: x has no value; the mean omits this run"]
    write_run("two", files={"own.csv": "species,group,x\nprey,all,nan\nprey,old,nan\n"})
    assert [remark.split(" has")[0] for remark in measured("two", columns=["own.csv:x"])[2]] == [
        "two/own.csv: x prey",
        "two/own.csv: x prey old",
    ]
    pathlib.Path("run/own.csv").write_text("x\n1\n")
    assert refusal(measured, columns=["own.csv:x"]).startswith("run/own.csv: has 1 rows and checksum ")


@metric(unit="m")
def from_centre(run):
    """The distance of each robot from the centre."""
    return run.agents.assign(from_centre=numpy.hypot(run.agents.x_m, run.agents.y_m))[
        ["time_s", "species", "from_centre"]
    ]


def test_a_function_of_a_run_has_a_value_for_each_species_and_a_curve():
    write_run(
        "run",
        of_agents=[
            robot(0, 0, "prey", 3.0, 4.0),
            robot(0, 1, "predator", 0.0, 2.0),
            robot(200, 1, "predator", 0.0, 4.0),
        ],
        until_s=600.0,
        result={"reached_s": 600.0},
    )
    assert own.own_metric(from_centre)[:2] == ("from_centre", "m")
    values, curve, remarks = measured(functions=[from_centre])
    assert (values, remarks) == ({("prey", "all"): 5.0, ("predator", "all"): 3.0}, [])
    assert curve == pytest.approx([5.0, 2.0, 4.0], nan_ok=True)  # the windows of each species up to its last row
    assert measured(functions=[from_centre], until_s=100.0)[0] == {
        ("prey", "all"): 5.0,
        ("predator", "all"): 2.0,
    }  # its tables end with --until


def test_a_function_without_a_mark_has_its_own_name_and_functions_need_not_be_importable():
    write_set("set", 3)
    births = 2

    def born(run):
        return (run.events.event == "birth").sum() / births

    found = pool.read_set(["set"], how=Measuring(functions=[born], jobs=2))
    assert (
        found.matrix()["born", "", "all", "1"].tolist()
        == [1.5] * 3
        == found.shadow.matrix()["born", "", "all", "1"].tolist()
    )


def one(**columns):
    return lambda run: pandas.DataFrame({"odd": [1.0], **{name: [value] for name, value in columns.items()}})


def raises(run):
    raise RuntimeError("no robot is there")


@pytest.mark.parametrize(
    "function, why",
    [
        (raises, "RuntimeError: no robot is there"),
        (lambda run: math.inf, "value = inf: must be finite, or nan if there is none"),
        (lambda run: "many", "ValueError: "),
        (lambda run: None, "TypeError: "),
        (one(time_s=600.5), "time_s = 600.5: must be >= 0 and <= 600"),
        (one(time_s=NAN), "time_s = nan: must be >= 0 and <= 600"),
        (one(species="wolf"), 'species = "wolf": must be one of prey, predator'),
        (one(group="a,b"), 'group = "a,b": must be letters, digits and _'),
        (lambda run: pandas.DataFrame({"old": [1.0]}), "the frame has no column odd; did you mean old?"),
        (lambda run: run.senses, "run/senses.csv: cannot be read: "),
    ],
)
def test_what_goes_wrong_in_a_function_names_metric_and_run(function, why):
    write_run("run", until_s=600.0)
    assert refusal(measured, functions=[metric(name="odd")(function)]).startswith(f"metric odd: run: {why}")


@pytest.mark.parametrize(
    "function",
    [
        lambda run: NAN,
        lambda run: pandas.DataFrame({"odd": []}),
        lambda run: pandas.DataFrame({"odd": [NAN, NAN], "time_s": [0.0, 1.0]}),
    ],
)
def test_a_run_with_nan_alone_gets_a_remark(function):
    write_run("run")
    values, _, remarks = measured(functions=[metric(name="odd")(function)])
    assert math.isnan(values["", "all"]) and remarks == ["run: odd has no value; the mean omits this run"]


@pytest.mark.parametrize(
    "name, unit, why",
    [
        ("hunger", "1", "metric hunger: trophic already has a metric with this name; choose another"),
        ("a b", "1", "metric a b: its name must be letters, digits and _"),
        ("a", "m,s", 'metric a: unit "m,s": must be letters, digits and _ . / ^ % -'),
        ("a", "", 'metric a: unit "": must be '),
        ("close", "1", "metric close: trophic already has a metric"),
        ("from_centre", "1", "metric from_centre: is given twice"),
    ],
)
def test_names_that_are_taken_or_not_words_are_refused_before_anything_is_measured(name, unit, why, monkeypatch):
    write_run("run", files={"crowd.csv": "close\n1\n"})
    monkeypatch.setattr(pool, "measure", lambda *_: pytest.fail("measured"))
    how = Measuring(columns=["crowd.csv:close"], functions=[from_centre, metric(name=name, unit=unit)(lambda run: 1.0)])
    assert refusal(pool.read_set, ["run"], how=how).startswith(why)
    with pytest.raises(RunError, match="must be a function of a run"):
        Measuring(functions=["from_centre"])


def test_a_choice_of_an_own_metric_may_name_its_species():
    write_run("run")
    assert measured(functions=[from_centre], metrics=["from_centre:prey", "velocity:prey"])[0].keys() == {
        ("prey", "all"),
        ("predator", "all"),
    }
    assert "did you mean from_centre?" in refusal(measured, functions=[from_centre], metrics=["from_center"])


FILE = """import trophic


@trophic.metric(unit="m")
def height(run):
    return 2.0


@trophic.metric
def width(run):
    return height(run) / 2


def unmarked(run):
    return 3.0
"""


def test_a_file_of_metrics_has_the_marked_functions():
    write_run("run")
    pathlib.Path("mine.py").write_text(FILE)
    found = own.read_metrics("mine.py")
    assert [each[:2] for each in found] == [("height", "m"), ("width", "1")]
    values = pool.read_set(["run"], how=Measuring(functions=found)).matrix()
    assert (values["height", "", "all", "m"][0], values["width", "", "all", "1"][0]) == (2.0, 1.0)
    for text, why in (
        ("x = 1\n", "has no metric: decorate a function of a run with @trophic.metric"),
        ("import nothing_of_that_name\n", "ModuleNotFoundError: "),
        ("def f(:\n", "SyntaxError: "),
        (None, "cannot be read: No such file or directory"),
    ):
        pathlib.Path("bad.py").write_text(text) if text else pathlib.Path("bad.py").unlink()
        with pytest.raises(RunError, match=f"^--metric-file bad.py: {why}"):
            own.read_metrics("bad.py")
