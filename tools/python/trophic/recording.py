# SPDX-License-Identifier: MIT
"""Reads replay.trp, the recording of a run: docs/recording.md describes its bytes."""
from __future__ import annotations

import dataclasses
import json
import math
import os
import pathlib
import struct
import zlib

import numpy

MAGIC = b"\x89TRP\r\n\x1a\n"
VERSION = 1
VERSION_OF_BODIES = 2  # of a run whose bodies differ


class RecordingError(ValueError):
    """A file that is not a recording or that is damaged; the message names it."""


@dataclasses.dataclass
class Recording:
    """The poses of all robots. F frames, R robots, J joints (0 on a backend without joints)."""

    head: dict
    """Description of the recording: robot, arena, species, fingerprint, seed, ..."""
    time_s: numpy.ndarray
    """(F,): times of the frames by the ecology's clock, in seconds."""
    position_m: numpy.ndarray
    """(F, R, 3): positions of the root links in metres, z up."""
    orientation: numpy.ndarray
    """(F, R, 4): rotations from the root's frame to the world, as unit quaternions w, x, y, z."""
    joint_rad: numpy.ndarray
    """(F, R, J): joint angles in the order of the robot's hinges; NaN beyond the hinges of a body."""
    complete: bool
    """Whether the file is complete; that of a killed run is not."""
    bodies: list[dict]
    """The bodies of the robots, in the format of head["robot"]; only one if all robots have the same."""
    body: numpy.ndarray
    """(F, R): the index in `bodies` of each robot's body."""
    set_down: numpy.ndarray
    """(F, R): whether a newborn's body was put in place before this frame, so that the position jumps without motion."""


def read_replay(path: str | os.PathLike, first: int = 0, last: int | None = None) -> Recording:
    """Reads a recording, or a run's folder with its replay.trp; or of it the frames first, first + 1, ..., last - 1.

    A truncated file has the frames of its whole blocks. Raises RecordingError for a file that is not a recording, has a different version or is
    damaged, and OSError as open does.
    """
    path = pathlib.Path(path)
    if path.is_dir():
        path = path / "replay.trp"
    if path.exists() and not path.is_file():  # on a pipe reading would wait
        raise RecordingError(f"{path}: is not a regular file")
    head, blocks, bodies, complete = _blocks(path, path.read_bytes())
    wanted = [block for block in blocks if block[0] + block[1] > first and (last is None or block[0] < last)]
    robots = head["robots"]
    if head["version"] == VERSION_OF_BODIES and len({robot for _, robot, _ in bodies[1]}) != robots:
        raise RecordingError(f"{path}: damaged, it does not name every robot's body")
    channels = max((block[2] for block in wanted), default=6 + head["joints"])
    parts = [numpy.zeros((channels, robots, 0))]
    for start, count, own, data in wanted:
        values = _unpack(path, start, data, (own, robots, count))
        values = numpy.concatenate([values, numpy.zeros((channels - own, robots, count))])
        parts.append(values[..., max(0, first - start) : None if last is None else last - start])
    values = numpy.concatenate(parts, axis=-1).transpose(2, 1, 0)
    begin = max(first, wanted[0][0]) if wanted else 0
    return _recording(head, numpy.arange(begin, begin + len(values)), values, complete, bodies)


def _blocks(path, content):
    if content[:8] != MAGIC:
        raise RecordingError(f"{path}: is not a trophic recording")
    head, blocks, frames, at = None, [], 0, 8
    bodies = ([], [])  # the bodies, and (frame, robot, body) of each that was set down
    while at + 12 <= len(content):
        (size,) = struct.unpack_from("<I", content, at)
        if at + 12 + size > len(content):
            break
        kind, data = content[at + 4 : at + 8], content[at + 8 : at + 8 + size]
        (checksum,) = struct.unpack_from("<I", content, at + 8 + size)
        if zlib.crc32(content[at + 4 : at + 8 + size]) != checksum:
            raise RecordingError(f"{path}: damaged, wrong checksum of the block at byte {at}")
        if head is None:
            head = _head(path, kind, {}, data)
        elif kind == b"HEAD":
            head = _head(path, kind, head, data)
        elif kind == b"POSE":
            differ = head["version"] == VERSION_OF_BODIES
            front = 12 if differ else 8
            start, count = struct.unpack_from("<II", data) if size > front else (0, 0)
            channels = struct.unpack_from("<I", data, 8)[0] if differ and size > front else 6 + head["joints"]
            if start != frames or count == 0 or not 6 <= channels <= 10**6:
                raise RecordingError(f"{path}: damaged, wrong frame numbers in the block at byte {at}")
            blocks.append((start, count, channels, data[front:]))
            frames += count
        elif kind == b"BODY" and head["version"] == VERSION_OF_BODIES:
            bodies[0].append(_body(path, data))
        elif kind == b"WHO " and head["version"] == VERSION_OF_BODIES:
            numbers = struct.unpack(f"<{size // 4}I", data) if size % 8 == 4 else (0, head["robots"], 0)
            known = [number < head["robots"] for number in numbers[1::2]] + [
                number < len(bodies[0]) for number in numbers[2::2]
            ]
            if not all(known) or numbers[0] < frames:
                raise RecordingError(f"{path}: damaged, wrong robots or bodies in the block at byte {at}")
            bodies[1].extend((numbers[0], robot, body) for robot, body in zip(numbers[1::2], numbers[2::2]))
        elif kind == b"DONE":
            if at + 12 + size != len(content):
                raise RecordingError(f"{path}: damaged, data after its end at byte {at + 12 + size}")
            return head, blocks, bodies, True
        at += 12 + size
    if head is None or not blocks:
        raise RecordingError(f"{path}: ends before its first frames")
    return head, blocks, bodies, False


def _body(path, data):
    try:
        body = json.loads(data)
        hinges = [link["hinge"] for link in body["links"][1:]]
    except (KeyError, TypeError, ValueError, RecursionError) as reason:
        raise RecordingError(f"{path}: cannot read a body: {reason!r}") from None
    return {**body, "hinges": len(hinges)}


def _head(path, kind, before, data):
    try:
        head = {**before, **json.loads(data)} if kind == b"HEAD" else {}
        version = head["version"]
        numbers = {name: head[name] for name in ("robots", "joints", "frames_per_tick", "steps_per_tick")}
        numbers = {**head["units"], **numbers, "first_time_s": head["first_time_s"], "tick_s": head["tick_s"]}
    except (KeyError, TypeError, ValueError, RecursionError) as reason:
        raise RecordingError(f"{path}: cannot read its header: {reason!r}") from None
    if version not in (VERSION, VERSION_OF_BODIES):
        raise RecordingError(
            f"{path}: format version {version!r}: must be one that this program reads, {VERSION} and {VERSION_OF_BODIES}"
        )
    for name, number in numbers.items():
        least = {"robots": 1, "joints": 0, "frames_per_tick": 1, "steps_per_tick": 1}.get(name)
        if type(number) not in ((int, float) if least is None else (int,)) or not abs(number) < 2**32:
            raise RecordingError(
                f"{path}: {name} = {number!r}: must be a {'' if least is None else 'whole '}number below 2^32"
            )
        if least is not None and number < least:
            raise RecordingError(f"{path}: {name} = {number!r}: must be >= {least}")
    return head


def _unpack(path, start, data, shape):
    size = 2 * math.prod(shape)
    try:
        content = zlib.decompressobj().decompress(data, size + 1)  # no more than that, whatever the block claims to be
    except (zlib.error, OverflowError):
        content = b""
    if len(content) != size:
        raise RecordingError(f"{path}: damaged in the block that begins at frame {start}")
    planes = numpy.frombuffer(content, numpy.uint8).astype(numpy.uint16)
    low, high = planes.reshape(2, *shape)
    folded = low + 256 * high
    return numpy.cumsum((folded >> 1) ^ (0 - (folded & 1)), axis=-1, dtype=numpy.uint16).astype(numpy.int16)


def _bodies_at(head, frames, bodies):
    body = numpy.zeros((len(frames), head["robots"]), dtype=int)
    set_down = numpy.zeros(body.shape, dtype=bool)
    for frame, robot, number in bodies[1]:
        body[frames >= frame, robot] = number
        set_down[frames == frame, robot] = frame > 0
    return body, set_down


def _recording(head, frames, values, complete, bodies):
    units, per_tick, steps = head["units"], head["frames_per_tick"], head["steps_per_tick"]
    step = -(-(frames % per_tick) * steps // per_tick)
    half_yaw = 0.5 * units["yaw_rad"] * values[..., 3]
    tilt = units["tilt_rad"] * values[..., 4:6]
    half_tilt = 0.5 * numpy.linalg.norm(tilt, axis=-1)
    w, share = numpy.cos(half_tilt), 0.5 * numpy.sinc(half_tilt / numpy.pi)
    x, y = share * tilt[..., 0], share * tilt[..., 1]
    cos, sin = numpy.cos(half_yaw), numpy.sin(half_yaw)
    orientation = numpy.stack([cos * w, cos * x - sin * y, cos * y + sin * x, sin * w], axis=-1)
    joints = units["joint_rad"] * values[..., 6:]
    body, set_down = _bodies_at(head, frames, bodies)
    if bodies[0]:
        hinges = numpy.array([one.pop("hinges") for one in bodies[0]])
        joints = numpy.where(numpy.arange(joints.shape[-1]) < hinges[body][..., None], joints, numpy.nan)
    return Recording(
        head=head,
        time_s=head["first_time_s"] + (frames // per_tick + step / steps) * head["tick_s"],
        position_m=units["position_m"] * values[..., :3],
        orientation=orientation / numpy.linalg.norm(orientation, axis=-1, keepdims=True),
        joint_rad=joints,
        complete=complete,
        bodies=bodies[0] or [head["robot"]],
        body=body,
        set_down=set_down,
    )
