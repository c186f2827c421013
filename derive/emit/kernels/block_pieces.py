"""The ranges of tip angles of many rods: groups of rods with ranges of one kind, on arrays."""

from __future__ import annotations

from typing import Any, NamedTuple

from numpy import concatenate, flatnonzero, unique, zeros

from derive.emit.kernels.arithmetic import epsilon, pi
from derive.emit.kernels.block_records import rows
from derive.emit.kernels.landscape_each import (
    RestEach,
    astroid_cusp_each,
    has_second_pair_each,
    mirror_landscape_each,
    no_field_each,
    oblique_alone_each,
    oblique_double_each,
    oblique_single_each,
    orthogonal_double_each,
    orthogonal_single_each,
    parallel_alone_each,
    parallel_double_each,
    parallel_single_each,
    ridge_couple_each,
)
from derive.emit.kernels.pieces_each import (
    clamp_in_each,
    fall_each,
    level_ground_each,
    ranges_each,
    reach_each,
    ridge_fall_each,
    ridge_ground_each,
)


class Rods(NamedTuple):
    """Rods in their own units of length: see ``equilibria.Rod``. case: their number in the block; slow: ℓ√(β + η).

    field_angle: an array, or the number that all share.
    """

    case: Any
    beta: Any
    eta: Any
    length: Any
    clamp_angle: Any
    field_angle: Any
    slow: Any


class Group(NamedTuple):
    """Ranges of one kind, one a rod. turns: whole turns of the clamp."""

    rods: Rods
    turns: Any
    piece: Any


class Straight(NamedTuple):
    """Rods whose clamp angle is a direction without moment."""

    rods: Rods
    rest: Any


def groups(rods):
    """The ranges of tips below the clamp angle, the straight rods, and the cases that are left to the scalar solver."""
    found, straight, doubtful = [], [], []
    for some, scene in landscapes(rods):
        clamp = clamp_in_each(scene.rests, some.clamp_angle)
        for rest, offset in zip(scene.rests, clamp.offsets, strict=True):
            flat = flatnonzero(offset == 0)
            if flat.size:
                straight.append(Straight(rows(some, flat), rows(rest, flat)))
        ground, low = ground_of_each(some, scene, clamp)
        doubtful.append(some.case[low])
        for here, build in ranges_each(ground):
            which = flatnonzero(here & ~low)
            if which.size:
                group = Group(rows(some, which), clamp.turns[which], build(rows(ground, which)))
                dips = nearly_ridge(group.rods, group.piece)
                doubtful.append(group.rods.case[dips])
                if not dips.all():
                    found.append(rows(group, ~dips))
    return found, straight, concatenate([zeros(0, dtype=int), *doubtful])


def nearly_ridge(rods, piece):
    """The ranges with a ridge that is not quite there: ``search.places``, whose closer samples are not taken here."""
    basin = piece.basin
    if basin.even or basin.passes or piece.low_kind == "level" or basin.far.quarters - basin.hill.quarters != 4:
        return zeros(rods.case.shape, dtype=bool)
    beta, eta, angle = rods.beta, rods.eta, abs(rods.field_angle)
    side = astroid_cusp_each(angle)
    missing = -ridge_couple_each(beta, eta, angle, side) / (beta + eta)
    cusp = angle + pi + side if rods.field_angle > 0 else pi - angle - side
    down = basin.well.angle - basin.hill.angle
    rise = reach_each(eta, basin.hill, fall_each(eta, basin.hill, 0, cusp - basin.hill.angle), down, 1)
    return (missing <= 0.3) & (rise > 0) & (rise < piece.width)


def landscapes(rods):
    """The rods in groups with landscapes of one kind, and those."""
    beta, eta, angle = rods.beta, rods.eta, rods.field_angle
    free, strong, alone = eta == 0, eta > beta, beta == 0
    along, across = ~free & (angle == 0), ~free & (angle == pi / 2)
    yield from built(rods, free, 0.0, lambda some: no_field_each(some.beta))
    yield from built(rods, along & alone, 0.0, lambda some: parallel_alone_each(some.eta))
    yield from built(rods, along & strong & ~alone, 0.0, lambda some: parallel_double_each(some.beta, some.eta))
    yield from built(rods, along & ~strong, 0.0, lambda some: parallel_single_each(some.beta, some.eta))
    yield from built(rods, across & strong, pi / 2, lambda some: orthogonal_double_each(some.beta, some.eta))
    yield from built(rods, across & ~strong, pi / 2, lambda some: orthogonal_single_each(some.beta, some.eta))
    for side, inclined in ((1, angle > 0), (-1, angle < 0)):
        inclined = inclined & ~free & ~across
        pair = inclined & ~alone
        pair[pair] = has_second_pair_each(beta[pair], eta[pair], side * angle[pair])
        yield from oblique(rods, inclined & alone, side, lambda beta, eta, angle: oblique_alone_each(eta, angle))
        yield from oblique(rods, pair, side, oblique_double_each)
        yield from oblique(rods, inclined & ~alone & ~pair, side, oblique_single_each)


def built(rods, mask, field_angle, build):
    """Some of the rods, with the field angle that they share, and their landscape."""
    if mask.any():
        some = rows(rods, flatnonzero(mask))._replace(field_angle=field_angle)
        yield some, build(some)


def oblique(rods, mask, side, build):
    """Some of the rods, and their landscape, built for positive field angles; a group for each field angle, which
    decides between formulas and so must be one number."""
    if not mask.any():
        return
    some = rows(rods, flatnonzero(mask))
    scene = build(some.beta, some.eta, side * some.field_angle)
    scene = scene if side > 0 else mirror_landscape_each(scene)
    angles, which = unique(some.field_angle, return_inverse=True)
    for number, angle in enumerate(angles.tolist()):
        here = flatnonzero(which == number)
        yield rows(some, here)._replace(field_angle=angle), rows(scene, here)


def ground_of_each(rods, scene, clamp):
    """The ground of rods with one kind of landscape, and where a ridge is too near the hill's level to be told."""
    rests = scene.rests
    level = scene._replace(rests=numbered(rests))
    if len(rests) == 3 or scene.level:
        return level_ground_each(rods.eta, level, clamp.offsets), zeros(rods.case.shape, dtype=bool)
    drop = ridge_fall_each(rods.beta, rods.eta, rods.field_angle, rests[0], rests[2])
    low = drop <= epsilon() ** 17 * (rods.beta + rods.eta)
    return ridge_ground_each(rods.eta, level, clamp.offsets, drop), low


def numbered(rests):
    """The directions with a number for the rest of their angle: only whether two are alike is asked from here on."""
    last = len(rests) - 1
    return tuple(RestEach(rest.quarters, k % last, *rest[2:]) for k, rest in enumerate(rests))
