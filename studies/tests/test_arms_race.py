# SPDX-License-Identifier: MIT
"""One shadow serves all criteria of a table, and no table with other deaths."""

import shutil

RUN = ["--backend", "kinematic", "--duration", 900, "--replay-hz", 0]


def test_one_shadow_serves_all_parent_rules_of_a_base_and_no_table_with_other_deaths(folder):
    for table in ("paper", "paper_most_escapes", "paper_ageing"):
        folder.run("trophic-arms-race", *RUN, "--replicates", 3, "--rules", table, "--shadow", "--out", table)
    for name in ("genomes.csv", "agents.csv"):
        own, other = (folder.rows(f"{table}/shadow/replicate-01/{name}") for table in ("paper", "paper_most_escapes"))
        assert [{**row, "origin": ""} for row in own] == [{**row, "origin": ""} for row in other], name
    off = [part for species in ("prey", "predator") for part in ("--set", f"rules.heredity.{species}.inherited=false")]
    folder.run("trophic-arms-race", *RUN, "--replicates", 2, "--rules", "paper_by_side", *off, "--out", "none")
    tables = ["genomes.csv", "agents.csv", "events.csv"]  # where neither side inherits, the runs are the shadow
    assert folder.bytes_of("none/replicate-01", tables) == folder.bytes_of("paper/shadow/replicate-01", tables)
    short = [
        "--shadow",
        "paper/shadow",
        "--program",
        shutil.which("trophic-arms-race"),
        "--duration",
        20,
        "--team-size",
        3,
        "--epochs",
        "0,900",
    ]
    folder.run("trophic", "contest", "paper_most_escapes", *short, "--out", "contests")
    refused = folder.call("trophic", "contest", "paper_ageing", *short, "--out", "refused")
    assert (
        refused.returncode == 2
        and "paper/shadow/replicate-00: is not a neutral shadow of paper_ageing/replicate-00" in refused.stderr
    )
