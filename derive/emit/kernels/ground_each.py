"""The kernels of ``ground`` on arrays.

Emitted by `derive emit` from kernels/ground.py: do not edit, change that file.

Digest of the inputs: sha256 ae480700e7afac49fe21a245c07b7dafd8b7349a1c09a11ddf511d7154743b67
"""

from __future__ import annotations

from derive.emit.kernels.arithmetic import epsilon, pi
from derive.emit.kernels.array_arithmetic import each_any_of, each_atan2, each_floor, each_pick, each_sqrt
from derive.emit.kernels.ground import Clamp, Ground, Ridge
from derive.emit.kernels.levels_each import fall_each, reach_each, ridge_fall_each, turn_to_each
from derive.emit.kernels.rests_each import offset_from_each, pick_rest_each


def clamp_in_each(rests, angle):
    """Whole turns such that the clamp lies from the first hill up to, but not at, its like a turn on."""
    turns = each_floor((angle - rests[0].angle) / (2 * pi))
    for _ in range(3):
        offsets = tuple(offset_from_each(rest, angle, turns) for rest in rests)
        shift = each_pick(offsets[0] < 0, -1, each_pick(offsets[-1] >= 0, 1, 0))
        if not each_any_of(shift != 0):
            break
        turns = turns + shift
    # One that counts as a direction without moment is as far from the others as that is.
    for there, met in zip(rests, offsets, strict=True):
        if each_any_of(met == 0):
            apart = zip(rests, offsets, strict=True)
            offsets = tuple(each_pick(met == 0, turn_to_each(rest, there), offset) for rest, offset in apart)
    return Clamp(turns, offsets)


def ridge_of_each(beta, eta, field_angle, scene):
    """The ridge of a landscape, seen from its first hill."""
    drop = 0
    if len(scene.rests) != 3 and not scene.level:
        drop = ridge_fall_each(beta, eta, field_angle, scene.rests[0], scene.rests[2])
    # A ridge lower by less than this would be passed only from within its square root of the hill.
    if drop <= epsilon() ** 17 * (beta + eta):
        return Ridge(0, 0, 0, True)
    return ridge_at_each(beta, eta, field_angle, scene.rests, drop)


def ridge_at_each(beta, eta, field_angle, rests, drop):
    """The ridge that is lower by ``drop`` than the hill."""
    if each_any_of(field_angle == 0):
        return ridge_along_each(beta, eta, drop)
    down, above = turn_to_each(rests[0], rests[1]), fall_each(eta, rests[2], 0, turn_to_each(rests[2], rests[1]))
    # Of a ridge that is next to its wells V tells at the hill nothing.
    by_hill = drop < above
    rest, amount = pick_rest_each(by_hill, rests[0], rests[1]), each_pick(by_hill, drop, above)
    distance = reach_each(eta, rest, amount, down, each_pick(by_hill, 1, -1))
    level, depth = each_pick(by_hill, distance, down - distance), each_pick(by_hill, down - distance, distance)
    return Ridge(drop, level, depth, by_hill)


def ridge_along_each(beta, eta, drop):
    """The ridge for a field along the force: with cos θ = 1 − 2β/η at its level, and −β/η at the well."""
    more, less, root = each_sqrt(eta + beta), eta - beta, each_sqrt(beta)
    level = 2 * each_atan2(root, each_sqrt(less))
    # tan of half the difference of the two.
    depth = 2 * each_atan2(eta * each_sqrt(less), (more + root) * (less + root * more))
    return Ridge(drop, level, depth, level < depth)


def ground_of_each(eta, scene, clamp, ridge):
    """The ground of a rod."""
    if ridge.drop > 0:
        return ridge_ground_each(eta, scene, clamp.offsets, ridge)
    if len(scene.rests) != 3 and not scene.level:
        scene = scene._replace(level=True, even=True)
    return level_ground_each(eta, scene, clamp.offsets)


def level_ground_each(eta, scene, at):
    """The ground without a ridge lower than the hill."""
    return Ground(eta, scene, at, 0, 0, 0, True, 0)


def ridge_ground_each(eta, scene, at, ridge):
    """The ground with a lower ridge."""
    rests = scene.rests
    # Near the far hill V says which is higher only by the distance from that hill.
    height = each_pick(
        at[2] < -at[4], fall_each(eta, rests[2], 0, at[2]), fall_each(eta, rests[4], 0, at[4]) - ridge.drop
    )
    return Ground(eta, scene, at, ridge.drop, ridge.level, ridge.depth, ridge.by_hill, height)
