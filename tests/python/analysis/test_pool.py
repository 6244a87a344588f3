# SPDX-License-Identifier: MIT
"""Which folders are one set, and why not; what is read of a run, and how damage is refused."""
import json
import os
import pathlib

import pytest
from hand_written import CATCH, NONE, WALK, refusal, robot, sum_of, write_run, write_set
from trophic import judge, metrics, pool
from trophic.description import describe
from trophic.metrics import AGENTS, EVENTS, Measuring, own
from trophic.report import analyze
from trophic.runs import read_runs, read_study
from trophic.words import NO_NEUTRAL


@pytest.fixture(autouse=True)
def in_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def pooled(*paths, **how):
    return pool.pooled_runs([pathlib.Path(path) for path in paths], Measuring(**how))


def read(path, **how):
    (values,) = pool.read_set([path], how=Measuring(jobs=1, **how)).values
    return values


def test_a_summary_has_the_time_that_each_run_lived():
    write_run("a", status="stopped", result={"reached_s": 100.0})
    of = pool.read_set(["a"], how=Measuring(jobs=1))
    (run,) = analyze.Outcome([of], [judge.summarize(of, [])], None).analysis(None).summary["sets"][0]["runs"]
    assert (run["status"], run["until_s"], run["lived_s"]) == ("stopped", 6000.0, 100.0)


BRANCH = {"run": "tape", "at_s": "700", "seed": "7", "fingerprint": "aa"}


def with_changes(rows):
    return {"files": {"changes.csv": "time_s,tick,number,value,before\n" + rows}}


CHANGED = with_changes("5,5,rules.a,2,1\n")


@pytest.mark.parametrize(
    "a, b, why",
    [
        (
            {},
            {"fingerprint": "bb", "rule_table": "released"},
            "b: fingerprint bb (released on kinematic 1), but a has aa (paper on kinematic 1); runs with different rules or parameters are not pooled: use --compare",
        ),
        (
            {"code": "0aaa"},
            {"code": "0bbb"},
            "b: made by 0bbb, but a by 0aaa; rules may have the same names but other code in different builds: --accept-other-build pools them",
        ),
        (
            {"code": "0aaa"},
            {"code": "0aaa", "continued": [{"code": "0bbb"}]},
            "b: made by 0aaa and 0bbb, but a by 0aaa; ",
        ),
        ({"code": "0aaa"}, {}, "b: made by an unknown build, but a by 0aaa; "),
        ({}, {"seed": 1}, "b: seed 1 as in a; a run counts only once as a replicate"),
        (
            {"origin": BRANCH},
            {"origin": {**BRANCH, "at_s": "900"}},
            "b: begins at 900 s of tape (seed 7), but a begins at 700 s of tape (seed 7); runs that share a past are not pooled with other runs",
        ),
        ({"origin": BRANCH}, {}, "b: begins at its beginning, but a begins at 700 s of tape (seed 7); "),
        (
            {},
            CHANGED,
            "b: 1 changes of parameters (changes.csv), but a has 0, or others; runs with different changes are not pooled",
        ),
        (
            CHANGED,
            with_changes("5,5,rules.a,3,1\n"),
            "b: 1 changes of parameters (changes.csv), but a has 1, or others; ",
        ),
        (
            {},
            {"agents_every_ticks": 5},
            "b: agents_every_ticks 5, but a has 1; runs with different detail in agents.csv are not pooled",
        ),
    ],
)
def test_runs_that_are_not_replicates_are_refused_also_if_they_are_cut(a, b, why):
    write_run("a", **a)
    write_run("b", **{"seed": 2, **b})
    for until_s in (None, 1.0):
        assert refusal(pooled, "a", "b", until_s=until_s).startswith(why)


@pytest.mark.parametrize(
    "a, b", [({}, {}), ({}, with_changes("")), ({}, with_changes("5,5,rules.a,1,1\n")), (CHANGED, CHANGED)]
)
def test_replicates_are_pooled(a, b):
    write_run("a", **a)
    write_run("b", 2, **b)
    found, remarks = pooled("a", "b")
    assert ([run.seed for run in found], remarks) == ([1, 2], [])


def test_builds_and_a_common_past_are_remarked_on():
    write_run("a", code="0aaa", origin=BRANCH)
    write_run("b", 2, code="0bbb", origin=BRANCH)
    assert pooled("a")[1] == []
    assert pooled("a", "b", accept_other_build=True)[1] == [
        "2 different builds made these runs: 0aaa and 0bbb; their rules may have the same names but other code",
        "all runs begin at 700 s of tape (seed 7): they share that past, so intervals cover its possible futures, not independent runs",
    ]


def test_status_and_duration_must_be_alike_unless_all_are_cut():
    write_run("a", result={"reached_s": 6000.0})
    write_run("b", 2, status="stopped", result={"reached_s": 100.0})
    write_run("c", 3, status="stopped", result={"reached_s": 200.0})
    write_run("d", 4, status="running")
    write_run("e", 5, status="running")
    assert refusal(pooled, "a", "b") == (
        'b: status "stopped" at 100 of 6000 s, but a has status "complete" at 6000 of 6000 s; runs of different length are not pooled: '
        "omit some, or cut all with --until"
    )
    assert "at 200 of 6000 s, but b has " in refusal(pooled, "b", "c")
    assert 'status "running" at an unknown time of 6000 s' in refusal(pooled, "d", "e")
    assert len(pooled("d")[0]) == 1
    assert [run.until_s for run in pooled("a", "b", "c", until_s=100.0)[0]] == [100.0] * 3
    assert (
        refusal(pooled, "a", "b", until_s=150.0)
        == "b: reached 100 s (status stopped): must be >= 150 s, as --until asks"
    )
    assert refusal(pooled, "d", until_s=3.0) == "d: reached 2 s (status running): must be >= 3 s, as --until asks"


def test_a_folder_of_replicates_is_the_runs_of_its_list():
    write_set("set", 2, shadow=False)
    write_run("set/replicate-01.incomplete-1", 2, fingerprint="bb")
    listing = pathlib.Path("set/replicates.json")
    text = listing.read_text()
    listing.write_text(text.replace("]", ', {"folder": "replicate-02"}]'))
    found, remarks = pooled("set")
    assert ([run.path.name for run in found], remarks) == (
        ["replicate-00", "replicate-01"],
        ["set/replicate-02: is missing, because the replicate was not run"],
    )
    for name, why in (
        ("../x", "folder = ../x: must be the name of a folder next to it"),
        ("..", "must be the name of a folder next to it"),
        ("\x1b[2J", "must be text without control characters"),
    ):
        listing.write_text(json.dumps({"replicates": [{"folder": name}]}))
        assert why in refusal(pooled, "set")
    listing.write_text('{"replicates": []}')
    assert refusal(pooled, "set") == "no runs found"
    for broken in ("{", "[]", '{"replicates": [1]}', "[" * 100_000):
        listing.write_text(broken)
        assert refusal(pooled, "set") in (
            "set/replicates.json: is not a JSON object",
            "set/replicates.json: replicates: must be a list of folders, as trophic writes it",
        )


@pytest.mark.parametrize(
    "heredity, more, why",
    [
        ("own_copy", {}, "its rule in slot heredity is own_copy: must be nothing_inherited"),
        ("nothing_inherited", {"rules": None}, "its rule in slot heredity is unknown: must be nothing_inherited"),
        (
            "nothing_inherited",
            {"params": {"seed": 9, "rules": {"floor": {"floor": 6}}}},
            "params/rules/floor/floor = 6: must be 7",
        ),
        ("nothing_inherited", {"backend": "mujoco"}, 'backend = "mujoco": must be "kinematic 1"'),
        (
            "nothing_inherited",
            {"status": "stopped"},
            'it has status "stopped" at an unknown time of 6000 s: must have status "complete" at 6000 of 6000 s',
        ),
    ],
)
def test_a_run_that_is_not_the_shadow_is_refused(heredity, more, why):
    write_run("run")
    write_run("shadow", 9, heredity=heredity, **more)
    assert refusal(pool.read_set, ["run"], "shadow") == f"shadow: is not a neutral shadow of run: {why}"


def test_the_shadow_in_the_folder_is_found_and_another_can_be_named():
    write_run("run", code="0aaa")
    assert pool.read_set(["run"]).shadow is None
    write_run("run/shadow", 9, heredity="nothing_inherited", code="0aaa")
    write_run("other", 7, heredity="nothing_inherited", code="0bbb")
    assert [run.seed for run in pool.read_set(["run"]).shadow.runs] == [9]
    assert (
        refusal(pool.read_set, ["run"], "other")
        == "other: made by 0bbb: must be made by 0aaa, as run (--accept-other-build takes it)"
    )
    found = pool.read_set(["run"], "other", Measuring(accept_other_build=True, until_s=1.0))
    assert [run.seed for run in found.shadow.runs] == [7] and (found.until_s, found.shadow.until_s) == (1.0, 1.0)
    run, shadow = (pool.read_pooled(pathlib.Path(path)) for path in ("run", "run/shadow"))
    shadow.manifest["rules"]["parent"] = "none"
    assert "rules/parent" in refusal(pool.check_shadow, run, shadow)
    pool.check_shadow(run, shadow, any_parent=True)


def test_the_neutral_null_in_the_folder_is_found_and_one_of_other_rules_or_runs_is_refused():
    of = own.own_metric(metrics.metric(lambda run: 1.0, name="genes", inherited=True))
    write_set("set", 2)
    found = pool.read_set(["set"], how=Measuring(jobs=1, functions=[of]))
    assert (
        found.inherited == {"genes"} and found.neutral is None and found.remarks == [f"set/replicate-00: {NO_NEUTRAL}"]
    )
    assert pool.read_set(["set"], how=Measuring(jobs=1)).remarks == []
    write_set("set/neutral", 2, shadow=False, heredity="neutral_own_copy", fingerprint="cc")
    found = pool.read_set(["set"], how=Measuring(jobs=1, functions=[of]))
    assert (
        list(found.nulls) == ["shadow", "neutral"]
        and found.remarks == []
        and describe(found).facts()["runs"].endswith("2 of the shadow, 2 of the neutral null")
    )
    assert len(read_runs("set").neutral) == 2 and list(read_study(".")) == ["set"]
    write_run("run", 5)
    write_run("run/neutral", 6, heredity="neutral_own_copy")
    assert refusal(pool.read_set, ["run"]) == "run/neutral: seed 6: must be that of a run that it repeats"
    pathlib.Path("run/neutral").rename("gone")
    write_run("run/neutral", 5)
    assert (
        refusal(pool.read_set, ["run"])
        == "run/neutral: is not a neutral null of run: its rule in slot heredity is own_copy: must be neutral_own_copy"
    )


@pytest.mark.parametrize(
    "entry, why",
    [
        ({"seed": -1}, "seed = -1: must be a whole number from 0 to 18446744073709551615"),
        ({"clock": {"until_s": -1}}, "clock.until_s = -1: must be >= 0 and <= 1e+08"),
        ({"clock": {"until_s": 1e300}}, "clock.until_s = 1e+300: must be >= 0 and <= 1e+08"),
        ({"clock": {"until_s": NONE}}, "clock.until_s = NaN: must be "),
        ({"agents_every_ticks": 0}, "agents_every_ticks = 0: must be a whole number from 1 to 9223372036854775807"),
        ({"species": None}, "'species': is missing"),
        (
            {"food_web": [{"hunter": "wolf", "victim": "prey"}]},
            'food_web: hunter = "wolf": must be one of prey, predator',
        ),
        ({"tables": {"../x.csv": {"rows": 1, "crc32": 1}}}, "tables: ../x.csv: must be the name of a file"),
        (
            {"tables": {"a.csv": {"rows": 1, "crc32": 2**32}}},
            "crc32 = 4294967296: must be a whole number from 0 to 4294967295",
        ),
        ({"tables": [1]}, "is not what trophic writes"),
        ({"origin": {}}, "'at_s': is missing"),
        ({"rules": {"floor": "\x9b2J"}}, '"\\u009b2J": must be text without control characters'),
        ({"arena": 10}, "is not what trophic writes"),
    ],
)
def test_a_broken_manifest_is_refused_by_file_and_field(entry, why):
    write_run("run", **entry)
    found = refusal(pooled, "run")
    assert found.startswith("run/manifest.json: ") and why in found


def test_what_is_not_a_run_is_refused():
    write_run("good")
    for file, call in (("manifest.json", "bare"), ("agents.csv", "broken")):
        os.remove(write_run(call, 2) / file)
        assert refusal(pool.read_set, ["good", call]).startswith(
            f"{call}/{file}: cannot be read: No such file or directory"
        )
    assert refusal(pooled, "none") == "none: does not exist"
    assert refusal(pooled, "good/agents.csv") == "good/agents.csv: is not a folder"
    pathlib.Path("good/manifest.json").write_text('{"fingerprint": "00ff"}')
    assert refusal(pooled, "good").startswith("good/manifest.json: ")


def test_a_table_has_the_rows_and_the_checksum_of_its_manifest():
    write_run("run", sums=True)
    path = pathlib.Path("run/events.csv")
    lines = path.read_text().splitlines(keepends=True)
    assert read("run").remarks == []
    for kept in ([0, 1, 2, 3, 4], [0, 1, 2, 3, 4, 4, 5], [0, 5, 4, 3, 2, 1], [0]):
        path.write_text("".join(lines[i] for i in kept))
        assert refusal(read, "run").startswith(f"run/events.csv: has {len(kept) - 1} rows and checksum ")
        assert refusal(read, "run").endswith("as its manifest says; the table was cut or modified after the run")


@pytest.mark.parametrize("cell", ["=1+1", "\u00ff", "", "1e999x"])
def test_a_time_that_is_no_number_is_refused_although_the_checksum_fits(cell):
    folder = write_run("run")
    path = folder / "agents.csv"
    lines = path.read_text().splitlines(keepends=True)
    path.write_text("".join([*lines[:2], cell + lines[2][lines[2].index(",") :], *lines[3:]]))
    manifest = folder / "manifest.json"
    manifest.write_text(json.dumps(json.loads(manifest.read_text()) | {"tables": {"agents.csv": sum_of(path)}}))
    assert refusal(read, "run") == f'run/agents.csv:3: time_s = "{cell}": must be a number'


def test_a_table_without_a_column_that_is_read_is_refused():
    folder = write_run("run", files={"resource.csv": "time_s,tick\n0,0\n", "energy.csv": "time_s,tick\nsoon,0\n"})
    (run,) = pooled(folder)[0]
    assert (
        refusal(run.table, "resource", ["time_s", "grown_J"])
        == 'run/resource.csv:1: no column "grown_J"; another kind of file?'
    )
    assert refusal(run.table, "energy") == "run/energy.csv: time_s: must be finite numbers, >= -1e60 and <= 1e60"


def test_damage_of_any_listed_file_is_refused():
    write_run(
        "run",
        sums=True,
        files={"genomes.csv": "id\n1\n", "phylogeny.csv": "id\n1\n"},
        recording={"frames": 1, "crc32": 1},
    )
    recording = pathlib.Path("run/replay.trp")
    assert refusal(read, "run") == "run/replay.trp: cannot be read: No such file or directory"
    recording.write_text("x")
    assert refusal(read, "run").endswith(
        ": must be 1, as its manifest says; the recording was cut or modified after the run"
    )
    for file in ("genomes.csv", "phylogeny.csv"):
        path = pathlib.Path("run", file)
        path.write_text("id\n2\n")
        assert refusal(read, "run").startswith(f"{path}: has 1 rows and checksum ")
        path.write_text("id\n1\n")


EVENT = "0,0,birth,0,prey,0,1,1,random,,0,,,,1,2\n"
AGENT = "0,0,0,9,prey,random,0,-1,0.5,1.5,0,0.7,,,\n"


@pytest.mark.parametrize(
    "file, row, why",
    [
        ("events", EVENT[:-3] + "\n", ":3: 15 cells, the header has 16"),
        ("events", EVENT.replace(",0,prey", ",x,prey"), ':3: id = "x": must be a whole number in range'),
        ("events", EVENT.replace(",0,prey", ",,prey"), ':3: id = "": must be a whole number in range'),
        ("events", "nan" + EVENT[1:], ':3: time_s = "nan": must be finite'),
        *(
            ("events", time_s + EVENT[1:], f':3: time_s = "{time_s}": must be >= 0 and <= 1e+08')
            for time_s in ("-1", "1e9", "1e300")
        ),
        ("events", EVENT.replace("prey", "wolf"), ':3: species = "wolf": must be a species of the run\'s manifest'),
        (
            "events",
            EVENT.replace("random,,0,", "random,,0,old"),
            ':3: cause = "old": must be one of the names that the program writes',
        ),
        ("agents", AGENT.replace(",0,-1", ",2,-1"), ':3: active = "2": must be 0 or 1'),
        ("agents", AGENT.replace("0.5", "far"), ':3: x_m = "far": must be a number'),
        ("agents", AGENT.replace("0.5", "inf"), ':3: x_m = "inf": must be finite'),
    ],
)
def test_a_fault_in_a_table_without_checksum_is_an_error_with_line_and_column(file, row, why):
    write_run("run")
    path = pathlib.Path("run", f"{file}.csv")
    header = path.read_text().splitlines(keepends=True)[0]
    path.write_text(header + (EVENT if file == "events" else AGENT) + row)
    assert refusal(read, "run") == f"{path}{why}"


def test_ticks_must_rise_and_be_those_of_the_manifest():
    write_run("run", of_agents=[robot(2, 0, "prey"), robot(1, 0, "prey")])
    assert refusal(read, "run") == 'run/agents.csv:3: tick = "1": must be >= that of the row before'
    write_run("thin", agents_every_ticks=2)
    assert refusal(read, "thin") == 'thin/agents.csv:4: tick = "1": must be a multiple of 2, as its manifest says'


@pytest.mark.parametrize(
    "text, why",
    [
        ("", ": has no header"),
        ("time_s", ": has no header"),
        ("generation,fitness\n1,2\n", ':1: no column "time_s"; another kind of file?'),
        ("\ufefftime_s\n", ":1: begins with a byte order mark; another kind of file?"),
    ],
)
def test_another_kind_of_file_is_refused(text, why):
    pathlib.Path(write_run("run"), "events.csv").write_text(text)
    assert refusal(read, "run") == f"run/events.csv{why}"


def test_columns_are_read_by_name_and_empty_cells_as_none():
    write_run(
        "run",
        of_agents=[
            robot(1, 9, "prey", 0.5, 1.5, tag=-1, active=0),
            robot(1, 3, "predator", adversary_id=9, hunger_ticks=12),
        ],
        sums=True,
    )
    path = pathlib.Path("run/agents.csv")
    rows = [line.split(",") for line in path.read_text().splitlines()]
    path.write_text("".join(",".join(reversed(row)) + "\n" for row in rows))
    for sums in (True, False):  # the table of a complete run, and of a killed one
        run = pool.read_pooled(pathlib.Path("run"))
        run.manifest["tables"]["agents.csv"] = sum_of(path)
        run.manifest["tables"] = run.manifest["tables"] if sums else {}
        found = run.load("agents.csv", AGENTS, [])
        assert found.adversary_id.tolist() == pytest.approx([NONE, 9.0], nan_ok=True)
        assert found.hunger_ticks.tolist() == pytest.approx([NONE, 12.0], nan_ok=True)
        assert (found.tag.tolist(), found.active.tolist(), found.x_m.tolist(), found.time_s.tolist()) == (
            [-1, 1],
            [0, 1],
            [0.5, 0.0],
            [2.0, 2.0],
        )
        assert run.load("events.csv", EVENTS, []).cause.astype(str).tolist() == ["", "", "", "caught", ""]


@pytest.mark.parametrize(
    "file, text, bound",
    [
        ("include/trophic/habitat/ecology_params.hpp", "longest_run_s = ", pool.MOST_TIME_S),
        ("tools/reading/run_manifest.cpp", "most_species = ", pool._MOST_SPECIES),
    ],
)
def test_bounds_are_those_of_the_programs(file, text, bound):
    assert f"{text}{bound:g};" in (pathlib.Path(__file__).parents[3] / file).read_text().replace("e8", "e+08")


def test_times_are_exact():
    times = [0.1 * 3, 200.00000000000003, 1e8 / 3]
    write_run(
        "run",
        of_agents=[{**robot(i, 0, "prey"), "time_s": time_s} for i, time_s in enumerate(times)],
        until_s=1e8,
        sums=True,
    )
    assert pool.read_pooled(pathlib.Path("run")).load("agents.csv", AGENTS, []).time_s.tolist() == times


def test_the_incomplete_end_of_a_killed_run_is_left_out_and_reported():
    write_run("run", of_agents=(*WALK, robot(2, 1, "predator")), status="running")
    for file in ("events.csv", "agents.csv"):
        path = pathlib.Path("run", file)
        path.write_text(path.read_text()[:-4])
    end = "truncated in the middle of a line (killed run?); all lines before it are used"
    assert read("run").remarks == [
        'run/manifest.json: status "running": the run did not reach its end',
        f"run/events.csv:6: {end}",
        f"run/agents.csv:6: {end}",
    ]
    run = pool.read_pooled(pathlib.Path("run"))
    assert len(run.load("events.csv", EVENTS, [])) == len(CATCH) - 1
    assert run.load("agents.csv", AGENTS, []).tick.tolist() == [
        0,
        0,
    ]  # the whole last tick goes: who is missing in it is unknown


def test_a_run_cut_in_time_is_read_up_to_there():
    write_run("run")
    (run,), _ = pooled("run", until_s=1.0)
    assert (len(run.load("events.csv", EVENTS, [])), len(run.load("agents.csv", AGENTS, []))) == (2, 2)
    assert (len(run.events), len(run.agents)) == (2, 2)  # as an own metric reads them


def test_results_do_not_depend_on_the_processes_and_all_runs_have_the_same_metrics():
    write_set("set", 6)
    for i in range(6):
        pathlib.Path(f"set/replicate-0{i}/own.csv").write_text(
            f"species,x\nprey,{i}\n{'bird,1' if i == 3 else ''}\n".replace("\n\n", "\n")
        )
        pathlib.Path(f"set/shadow/replicate-0{i}/own.csv").write_text("species,x\nprey,1\n")
    found = [pool.read_set(["set"], how=Measuring(columns=["own.csv:x"], jobs=jobs)) for jobs in (1, 3)]
    for a, b in zip(*[of.values + of.shadow.values for of in found]):
        assert a.values.equals(b.values) and a.curves.equals(b.curves)
        assert a.values[["metric", "species"]].equals(found[0].values[0].values[["metric", "species"]])
    prey, bird = (name for name in found[0].metrics() if name.metric == "x")
    assert (prey.species, bird.species) == ("prey", "bird")
    assert found[0].matrix()[prey].tolist() == [0, 1, 2, 3, 4, 5]
    assert found[0].matrix()[bird].tolist() == pytest.approx([NONE] * 3 + [1] + [NONE] * 2, nan_ok=True)


def test_extinction_has_rows_only_if_a_species_is_gone_in_some_run_or_is_asked_for():
    alive = [
        robot(tick, i, species, hunger_ticks=0)
        for tick in range(3)
        for i, species in enumerate(WALK[i]["species"] for i in (0, 1))
    ]
    write_run("a", of_agents=alive)
    write_run("b", 2, of_agents=alive)
    write_run("c", 3, of_agents=[row for row in alive if row["id"] == 0 or row["tick"] == 0])

    def found(*paths, **how):
        matrix = pool.read_set(paths, how=Measuring(**how)).matrix()
        return {species: of.tolist() for (metric, species, *_), of in matrix.items() if metric == "extinct"}

    assert found("a", "b") == {}
    assert found("a", "c") == {"predator": [0.0, 1.0]}
    assert found("a", "b", metrics=["extinct"]) == {"prey": [0.0, 0.0], "predator": [0.0, 0.0]}


@pytest.mark.parametrize(
    "how, why",
    [
        ({"metrics": ["hungr"]}, "did you mean hunger?"),
        (
            {"metrics": ["deaths:wolf"]},
            "metric deaths:wolf: must be METRIC, METRIC:SPECIES or METRIC:SPECIES:GROUP of attribution_caught, ",
        ),
        ({"metrics": ["tag_symmetry"]}, "metric tag_symmetry: must be "),
        ({"columns": ["own.csv:hunger"]}, "--column own.csv:hunger: a metric already has this name; rename the column"),
        ({"columns": ["none.csv:x"]}, "--column none.csv:x: run has no such file"),
        ({"until_s": -1}, "--until -1: must be > 0"),
        ({"jobs": 0}, "--jobs 0: must be >= 1"),
    ],
)
def test_what_cannot_be_is_said_before_anything_is_measured(how, why, monkeypatch):
    write_run("run", tags=[1, 2, 3], files={"own.csv": "hunger\n1\n"})
    monkeypatch.setattr(pool, "measure", lambda *_: pytest.fail("measured"))
    assert why in refusal(lambda: pool.read_set(["run"], how=Measuring(**how)))
