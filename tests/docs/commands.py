# SPDX-License-Identifier: MIT
"""Checks the command lines in documents: trophic's programs by --help and --print-config; scripts, CMake and ctest by
reading the tree."""

import functools
import json
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

INSTALLED = ("trophic", "trophic-predator-prey", "trophic-worlds")
STUDIES = (
    "trophic-ablations",
    "trophic-arms-race",
    "trophic-bodies",
    "trophic-open-ended",
    "trophic-race",
    "trophic-readings",
)  # of studies/CMakeLists.txt
SYSTEM = {
    "apt-get", "bash", "black", "cat", "cd", "clang-format", "cp", "diff", "docker", "export", "for", "do", "done", "git", "head", "less", "ls", "mkdir", "mv", "pandoc",
    "parallel", "pip", "pre-commit", "rm", "run-clang-tidy", "sbatch", "simulate", "snakemake", "source", "squeue", "srun", "sudo", "tar",
    "dpkg-buildpackage", "lintian", "pkg-config", "g++", "clang++", "mpirun", "xdg-open", "CXX=clang++",
}  # fmt: skip
PLACEHOLDER = re.compile(r"^[A-Z][A-Z_]*$")


def is_command(text: str) -> bool:
    """Whether this text in code style begins a command line of trophic."""
    words = text.split()
    first = words[0] if words else ""
    if first in ("cmake", "ctest", "python3", "scripts", "pip", "mpirun"):
        return len(words) > 1
    return (
        first in INSTALLED + STUDIES
        and len(words) > 1
        or bool(re.match(r"(build/[\w/]+/[\w-]+|scripts/[\w-]+|studies/reproduce|(studies|docs)/[\w/]+\.py)$", first))
    )


class Programs:
    def __init__(self, folder: pathlib.Path | None, named: dict[str, str]):
        self.folder = folder
        self.named = named

    def find(self, name: str) -> str | None:
        if name in self.named:
            return self.named[name]
        if self.folder and not (self.folder / name).exists():
            sys.exit(f"{self.folder}: {name} is not built")
        return str(self.folder.resolve() / name) if self.folder else None

    @functools.cache
    def help(self, *command: str) -> str:
        return subprocess.run([*command, "--help"], capture_output=True, text=True).stdout


def split(line: str) -> list[list[str]]:
    """The commands of a line of shell; none if it is a call in CMake."""
    if re.match(r"\s*\w+\(", line):
        return []
    try:
        lexer = shlex.shlex(line, posix=True, punctuation_chars="|&;<>()")
        lexer.whitespace_split = True
        words = list(lexer)
    except ValueError:
        return []
    found: list[list[str]] = [[]]
    skip = False
    for word in words:
        if word in ("&&", "||", "|", ";", "&", "(", ")"):
            found.append([])
            skip = False
        elif word in ("<", ">", ">>", "<(", "2>"):
            skip = word != "<("
            if word == "<(":
                found.append([])
        elif skip:
            skip = False
        else:
            found[-1].append(word)
    return [command for command in found if command]


def lines_of(code: str) -> list[tuple[int, str]]:
    lines, start, text = [], 0, ""
    for offset, line in enumerate(code.splitlines()):
        if not text:
            start = offset
        text += line.rstrip("\\")
        if not line.endswith("\\"):
            lines.append((start, text))
            text = ""
    return lines


def presets(tree, kind: str) -> set[str]:
    listed = json.loads((tree.root / "CMakePresets.json").read_text())[kind]
    return {preset["name"] for preset in listed if not preset.get("hidden")}


def cmake_text(tree) -> str:
    return "\n".join(
        path.read_text() for path in tree.files if path.name == "CMakeLists.txt" or path.suffix == ".cmake"
    )


def value_after(words: list[str], flag: str) -> str | None:
    return words[words.index(flag) + 1] if flag in words and words.index(flag) + 1 < len(words) else None


def check_cmake(tree, own: str, words: list[str]) -> list[str]:
    if "--list-presets" in words or "--install" in words:
        return []
    kind = "buildPresets" if "--build" in words else "configurePresets"
    preset = value_after(words, "--preset")
    offences = (
        [f"no {kind[:-7]} preset '{preset}'"]
        if preset and not PLACEHOLDER.match(preset) and preset not in presets(tree, kind)
        else []
    )
    text = cmake_text(tree) + own
    for target in words[words.index("--target") + 1 :] if "--target" in words else []:
        if target.startswith("-"):
            break
        if not PLACEHOLDER.match(target) and not re.search(rf"(?<![\w-]){re.escape(target)}(?![\w-])", text):
            offences.append(f"CMake has no target '{target}'")
    for option in re.findall(r"^-D(\w+)", "\n".join(words), re.MULTILINE):
        if not option.startswith("CMAKE_") and not re.search(rf"\b{option}\b", text):
            offences.append(f"CMake reads no '{option}'")
    return offences


def check_ctest(tree, words: list[str]) -> list[str]:
    offences = []
    preset, label, expression = (value_after(words, flag) for flag in ("--preset", "-L", "-R"))
    if preset and preset not in presets(tree, "testPresets"):
        offences.append(f"no test preset '{preset}'")
    if label and not any((tree.root / folder).is_dir() for folder in (f"tests/{label}", f"tools/{label}/tests")):
        offences.append(f"no tests are labelled '{label}'")
    if expression:
        tests = re.findall(r'(?:TEST_CASE(?:_TEMPLATE_DEFINE)?\(|NAME\s+)"([^"]+)"', tree.text) + re.findall(
            r"trophic_add_test\(\s*(\w+)", tree.text
        )
        tests += [
            f"program: {quoted or bare}"
            for quoted, bare in re.findall(r'trophic_add_program_test\(\s*(?:"([^"]+)"|(\w+))', tree.text)
        ]
        if not any(re.search(expression, test) for test in tests):
            offences.append(f"no test's name matches '{expression}'")
    return offences


def check_script(tree, words: list[str]) -> list[str]:
    path = tree.root / words[0]
    if not path.is_file():
        return [f"there is no {words[0]}"]
    text = path.read_text()
    return [
        f"{words[0]} has no {word.split('=')[0]}"
        for word in words[1:]
        if re.match(r"--\w", word) and word.split("=")[0] not in text
    ]


def check_built(tree, words: list[str]) -> list[str]:
    """build/PRESET/FOLDER/PROGRAM other than the installed programs."""
    if words[0].count("/") < 2:
        return [f"nothing is called '{words[0]}'"]
    preset, *folders, name = pathlib.PurePath(words[0]).parts[1:]
    offences = [] if preset in presets(tree, "configurePresets") else [f"no configure preset '{preset}'"]
    lists = tree.root.joinpath(*folders) / "CMakeLists.txt"
    if PLACEHOLDER.match(name):
        return offences
    text = lists.read_text() if lists.is_file() else ""
    for variable, values in re.findall(r"foreach\((\w+) ([^)]*)\)", text):
        text += "".join(
            " " + word.replace(f"${{{variable}}}", value)
            for value in values.split()
            for word in re.findall(rf"\S*\${{{variable}}}\S*", text)
        )
    if not re.search(rf"(?<![\w-]){re.escape(name)}(?![\w-])", text):
        offences.append(f"{'/'.join(folders)} builds no '{name}'")
    return offences


def check_flags(help_text: str, words: list[str], program: str) -> list[str]:
    known = set(re.findall(r"(?<![\w-])(--?[A-Za-z][\w-]*)", help_text))
    return [
        f"{program} has no {word.split('=')[0]}"
        for word in words
        if re.match(r"--?[A-Za-z]", word) and word.split("=")[0] not in known
    ]


def accepted(executable: str, arguments: list[str], folder: str) -> subprocess.CompletedProcess:
    return subprocess.run([executable, *arguments], cwd=folder, capture_output=True, text=True, timeout=60)


def only_options(arguments: list[str], names: list[str]) -> list[str]:
    """These options and their values."""
    kept, keeps = [], False
    for word in arguments:
        keeps = word.split("=")[0] in names if word.startswith("--") else keeps
        kept += [word] if keeps else []
    return kept


def parsed(executable: str, arguments: list[str], ask: str, folder: str) -> subprocess.CompletedProcess:
    """Parses the arguments, running nothing: `ask` prints and stops. A second call leaves out the options that it does not go with."""
    if "--print-table" in arguments:
        return accepted(executable, arguments, folder)
    done = accepted(executable, [*arguments, ask], folder)
    alone = re.search(rf"not with {ask}, which combines with (.*) only", done.stderr)
    return (
        accepted(executable, [*only_options(arguments, re.findall(r"--[\w-]+", alone[1])), ask], folder)
        if alone
        else done
    )


def check_ours(tree, programs: Programs, name: str, words: list[str]) -> list[str]:
    for word in words[1:]:
        path = word.split("=")[-1]
        if re.match(r"(models|examples|tests|docs|scripts|studies)/", path) and not (tree.root / path).exists():
            return [f"there is no {path}"]
    executable = programs.find(name)
    if executable is None:
        return []
    # a placeholder means any value of its kind; ROBOTS... and [OPTIONS] any number of words
    arguments = [word for word in words[1:] if not re.fullmatch(r"\[.*\]|.*\.\.\.", word)]
    if name == "trophic":
        command = [word for word in arguments[:1] if not word.startswith("-") and not PLACEHOLDER.match(word)]
        help_text = programs.help(executable, *command)
        if command and f"trophic {command[0]}" not in help_text:
            return [f"trophic has no command '{command[0]}'"]
        offences = check_flags(help_text + " --help", arguments, " ".join(["trophic", *command]))
        if offences or not command:
            return offences
    else:
        command = []
        offences = check_flags(programs.help(executable) + " --help", arguments, name)
        if offences:
            return offences
    if (
        any(PLACEHOLDER.match(word.split("=")[-1]) or "$" in word for word in arguments)
        or (name == "trophic" and "--resume" in arguments)
        or "--plan" in arguments
    ):
        return []  # values of placeholders, runs to resume, sweep files and their folders are the reader's
    ask = "--print-config"
    if ask not in programs.help(executable, *command):
        return []
    with tempfile.TemporaryDirectory() as folder:  # the arguments are parsed, nothing is run
        (pathlib.Path(folder) / "models").symlink_to(tree.root / "models")
        done = parsed(executable, arguments, ask, folder)
        if "was built without it" in done.stderr:  # the engine is not an argument of the reader's
            done = parsed(executable, [*arguments, "--backend", "kinematic"], ask, folder)
    return [] if done.returncode == 0 else [f"refused: {done.stderr.strip()}"]


def check_command(tree, programs: Programs, own: str, words: list[str], every_word_known: bool) -> list[str]:
    """`own`: the code of the document, which declares a reader's programs in CMake."""
    while words and re.match(r"[A-Z_]+=", words[0]):
        words = words[1:]
    if not words:
        return []
    first = words[0]
    name = pathlib.PurePath(first).name
    if first == "cmake":
        return check_cmake(tree, own, words)
    if first == "ctest":
        return check_ctest(tree, words)
    if first == "python3" and len(words) > 1 and words[1].endswith(".py"):
        return [] if f"file {words[1]}" in own else check_script(tree, words[1:])
    if name in INSTALLED or name in programs.named:
        if first.startswith("build/") and pathlib.PurePath(first).parts[1] not in presets(tree, "configurePresets"):
            return [f"no configure preset '{pathlib.PurePath(first).parts[1]}'"]
        return check_ours(tree, programs, name, words)
    if name in STUDIES or re.search(rf"trophic_add_experiment\({re.escape(name)} ", own):
        reference = programs.find("trophic-predator-prey")
        return check_flags(programs.help(reference), words[1:], name) if reference else []
    if re.search(rf"add_executable\({re.escape(name)} ", own):
        return []
    if first.startswith("build/"):
        return check_built(tree, words)
    if first.startswith(("scripts/", "studies/", "docs/", "tests/")):
        return check_script(tree, words)
    if first.startswith("trophic-") or (every_word_known and first not in SYSTEM and first != "python3"):
        return [f"nothing is called '{first}'"]
    return []


def check(tree, document, programs: Programs) -> list[str]:
    if document.path.name == "CHANGELOG.md":
        return []
    offences = []
    own = "\n".join(f"{' '.join(block.note)}\n{block.code}" for block in document.blocks if block.language != "sh")
    for block in document.blocks:
        if block.language in ("sh", "text", ""):
            for offset, line in lines_of(block.code):
                for words in split(line):
                    offences += [
                        f"{block.line + 1 + offset}: {text}"
                        for text in check_command(tree, programs, own, words, block.language == "sh")
                    ]
    for line, span in document.spans:
        if is_command(span):
            for words in split(span):
                offences += [f"{line}: {text}" for text in check_command(tree, programs, own, words, False)]
        elif re.match(r"--?[a-z][\w-]+", span) and programs.folder:
            offences += [f"{line}: {text}" for text in check_flag_alone(tree, programs, span)]
    return offences


def check_flag_alone(tree, programs: Programs, span: str) -> list[str]:
    """`--shadow` in prose: one of trophic's programs must have it."""
    words = span.split()
    if not words[0].startswith("--"):
        return []
    flag = words[0].split("=")[0]
    texts = [programs.help(programs.find(name)) for name in INSTALLED]
    trophic = programs.find("trophic")
    for command in re.findall(r"^  ([a-z][\w-]+) ", texts[0].split("Subcommands:")[-1], re.MULTILINE):
        texts.append(programs.help(trophic, command))
    if any(re.search(rf"(?<![\w-]){re.escape(flag)}(?![\w-])", text) for text in texts) or f'"{flag}' in tree.text:
        if flag == "--set" and len(words) > 1 and "." in words[1] and not PLACEHOLDER.match(words[1]):
            key = words[1].split("=")[0]
            return (
                []
                if re.search(rf"\b{re.escape(key.split('.')[-1])}\b", tree.text)
                else [f"no number is called '{key}'"]
            )
        return []
    return [f"no program has {flag}"]
