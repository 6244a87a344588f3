#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""release_test.py ROOT CMAKE: the release archive of the last commit is reproducible, has its checksum and names its commit without git,
and another version in a file that states it is refused."""

import pathlib
import subprocess
import sys
import tarfile
import tempfile

ROOT, CMAKE = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
SKIPPED = 77


def run(*command, cwd, expected=0):
    done = subprocess.run(command, cwd=cwd, capture_output=True, text=True)
    assert done.returncode == expected, f"{command}: exit code {done.returncode}\n{done.stdout}{done.stderr}"
    return done.stdout + done.stderr


def main() -> int:
    if not (ROOT / ".git").exists():
        print("not a git checkout")
        return SKIPPED
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        run("git", "clone", "-q", ROOT, "clone", cwd=folder)
        clone = folder / "clone"
        for out in ("first", "second"):
            run("scripts/release", folder / out, cwd=clone)
        archives = [next((folder / out).glob("*.tar.gz")) for out in ("first", "second")]
        assert archives[0].read_bytes() == archives[1].read_bytes(), "two archives of one commit differ"
        run("sha256sum", "--check", f"{archives[0].name}.sha256", cwd=folder / "first")
        with tarfile.open(archives[0]) as archive:
            archive.extractall(folder)
        tree = folder / archives[0].name.removesuffix(".tar.gz")
        assert not (tree / ".git").exists() and (tree / "CMakeLists.txt").is_file()
        commit = run("git", "rev-parse", "HEAD", cwd=clone).strip()
        script = tree / "cmake/source-revision.cmake"
        run(CMAKE, f"-DSOURCE={tree}", f"-DFILE={folder}/revision.cpp", "-P", script, cwd=folder)
        assert f'"{commit[:12]}"' in (folder / "revision.cpp").read_text(), "the archive does not name its commit"
        run(CMAKE, f"-DSOURCE={folder}", f"-DFILE={folder}/other.cpp", "-P", script, cwd=folder)
        assert '"unknown"' in (folder / "other.cpp").read_text(), "a user's sources must not have trophic's revision"

        citation = clone / "CITATION.cff"
        citation.write_text(citation.read_text().replace("\nversion: ", "\nversion: 9"))
        run(
            "git",
            "-c",
            "user.name=test",
            "-c",
            "user.email=test@example.org",
            "commit",
            "-qam",
            "Another version",
            cwd=clone,
        )
        assert "CITATION.cff: version must be" in run("scripts/release", folder / "third", cwd=clone, expected=1)
    return 0


if __name__ == "__main__":
    sys.exit(main())
