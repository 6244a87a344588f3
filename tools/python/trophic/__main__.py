# SPDX-License-Identifier: MIT
"""`python3 -m trophic VERB ...` does what `trophic VERB ...` does. The programs trophic-VERB start this file in isolated mode."""
import pathlib
import sys

if not __package__:
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from trophic.command import main  # noqa: E402

main(sys.argv[1:])
