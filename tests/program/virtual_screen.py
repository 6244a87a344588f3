# SPDX-License-Identifier: MIT
"""A screen for programs with windows: Xvfb, with keys, mouse and screenshots."""

import os
import shutil
import subprocess
import time

NEEDED = ("Xvfb", "xdotool", "ffmpeg")
SKIPPED = 77


def missing():
    """The packages that it lacks, as one sentence; empty if none."""
    names = [name for name in NEEDED if shutil.which(name) is None]
    return f"not there: {', '.join(names)}; apt-get install xvfb xdotool ffmpeg" if names else ""


class VirtualScreen:
    """A display of 1280x720."""

    def __enter__(self):
        reads, writes = os.pipe()
        command = ["Xvfb", "-displayfd", str(writes), "-screen", "0", "1280x720x24", "-nolisten", "tcp", "-noreset"]
        self.server = subprocess.Popen(command, pass_fds=[writes], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(writes)
        with os.fdopen(reads) as pipe:
            self.display = f":{pipe.readline().strip()}"
        self.environment = {**os.environ, "DISPLAY": self.display}
        return self

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()

    def xdotool(self, *words):
        done = subprocess.run(["xdotool", *map(str, words)], env=self.environment, capture_output=True, text=True, timeout=60)
        return done.stdout.strip()

    def window(self, name, program, within_s=120):
        """The number of the window whose title has `name`, as soon as the program shows it."""
        for _ in range(10 * within_s):
            if program.poll() is not None:
                raise AssertionError(f"the program ended: {program.communicate()}")
            found = self.xdotool("search", "--name", name).split()
            if found:
                return found[0]
            time.sleep(0.1)
        raise AssertionError(f"no window called {name}")

    def screenshot(self, path):
        command = ["ffmpeg", "-v", "error", "-y", "-f", "x11grab", "-video_size", "1280x720", "-i", self.display, "-frames:v", "1", str(path)]
        subprocess.run(command, check=True, timeout=60, capture_output=True)
