"""What the ranges of tip angles are told by: the clamp among the directions, and the level of a ridge."""

from __future__ import annotations

from typing import NamedTuple

from derive.emit.kernels.arithmetic import any_of, atan2, epsilon, floor, pi, pick, sqrt
from derive.emit.kernels.levels import fall, reach, ridge_fall, turn_to
from derive.emit.kernels.rests import Landscape, offset_from, pick_rest


class Clamp(NamedTuple):
    """The clamp angle in a landscape: whole turns, and its offset from each direction without moment."""

    turns: int
    offsets: tuple[float, ...]


def clamp_in(rests, angle):
    """Whole turns such that the clamp lies from the first hill up to, but not at, its like a turn on."""
    turns = floor((angle - rests[0].angle) / (2 * pi))
    for _ in range(3):
        offsets = tuple(offset_from(rest, angle, turns) for rest in rests)
        shift = pick(offsets[0] < 0, -1, pick(offsets[-1] >= 0, 1, 0))
        if not any_of(shift != 0):
            break
        turns = turns + shift
    # One that counts as a direction without moment is as far from the others as that is.
    for there, met in zip(rests, offsets, strict=True):
        if any_of(met == 0):
            apart = zip(rests, offsets, strict=True)
            offsets = tuple(pick(met == 0, turn_to(rest, there), offset) for rest, offset in apart)
    return Clamp(turns, offsets)


class Ridge(NamedTuple):
    """A ridge that is lower than the hill; all are 0 where none is.

    drop: V(hill) − V(ridge). level: from the hill to the level of the ridge, depth: from there to the well; by_hill:
    level is told by the hill, depth by the well if not.
    """

    drop: float
    level: float
    depth: float
    by_hill: bool


def ridge_of(beta, eta, field_angle, scene):
    """The ridge of a landscape, seen from its first hill."""
    drop = 0
    if len(scene.rests) != 3 and not scene.level:
        drop = ridge_fall(beta, eta, field_angle, scene.rests[0], scene.rests[2])
    # A ridge lower by less than this would be passed only from within its square root of the hill.
    if drop <= epsilon() ** 17 * (beta + eta):
        return Ridge(0, 0, 0, True)
    return ridge_at(beta, eta, field_angle, scene.rests, drop)


def ridge_at(beta, eta, field_angle, rests, drop):
    """The ridge that is lower by ``drop`` than the hill."""
    if any_of(field_angle == 0):
        return ridge_along(beta, eta, drop)
    down, above = turn_to(rests[0], rests[1]), fall(eta, rests[2], 0, turn_to(rests[2], rests[1]))
    # Of a ridge that is next to its wells V tells at the hill nothing.
    by_hill = drop < above
    rest, amount = pick_rest(by_hill, rests[0], rests[1]), pick(by_hill, drop, above)
    distance = reach(eta, rest, amount, down, pick(by_hill, 1, -1))
    level, depth = pick(by_hill, distance, down - distance), pick(by_hill, down - distance, distance)
    return Ridge(drop, level, depth, by_hill)


def ridge_along(beta, eta, drop):
    """The ridge for a field along the force: with cos θ = 1 − 2β/η at its level, and −β/η at the well."""
    more, less, root = sqrt(eta + beta), eta - beta, sqrt(beta)
    level = 2 * atan2(root, sqrt(less))
    # tan of half the difference of the two.
    depth = 2 * atan2(eta * sqrt(less), (more + root) * (less + root * more))
    return Ridge(drop, level, depth, level < depth)


class Ground(NamedTuple):
    """What the ranges of a rod are told by: its landscape, the clamp's offsets from its directions, and the ridge.

    drop, level, depth, by_hill: see ``Ridge``; height: V(ridge) − V(clamp), or 0 where no ridge is lower than the hill.
    """

    eta: float
    scene: Landscape
    at: tuple[float, ...]
    drop: float
    level: float
    depth: float
    by_hill: bool
    height: float


def ground_of(eta, scene, clamp, ridge):
    """The ground of a rod."""
    if ridge.drop > 0:
        return ridge_ground(eta, scene, clamp.offsets, ridge)
    if len(scene.rests) != 3 and not scene.level:
        scene = scene._replace(level=True, even=True)
    return level_ground(eta, scene, clamp.offsets)


def level_ground(eta, scene, at):
    """The ground without a ridge lower than the hill."""
    return Ground(eta, scene, at, 0, 0, 0, True, 0)


def ridge_ground(eta, scene, at, ridge):
    """The ground with a lower ridge."""
    rests = scene.rests
    # Near the far hill V says which is higher only by the distance from that hill.
    height = pick(at[2] < -at[4], fall(eta, rests[2], 0, at[2]), fall(eta, rests[4], 0, at[4]) - ridge.drop)
    return Ground(eta, scene, at, ridge.drop, ridge.level, ridge.depth, ridge.by_hill, height)
