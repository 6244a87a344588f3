# SPDX-License-Identifier: MIT
"""`python3 -m trophic VERB ...` does what `trophic VERB ...` does. The programs trophic-VERB start this file in isolated mode."""
import os
import signal
import sys

for number in (signal.SIGINT, signal.SIGTERM):  # until the command begins: an exception in an import may be lost
    if signal.getsignal(number) != signal.SIG_IGN:
        signal.signal(number, lambda *_: os._exit(3))
signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})
if not __package__:
    sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
elif sys.path[0] == os.getcwd():
    del sys.path[0]  # of -m: no file next to a user's runs is taken for a module

from trophic.command import main  # noqa: E402

main(sys.argv[1:])
