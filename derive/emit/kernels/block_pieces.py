"""The ranges of tip angles of many rods: groups of rods with ranges of one kind, on arrays."""

from __future__ import annotations

from typing import Any, NamedTuple

from numpy import abs, arange, concatenate, flatnonzero, full, unique, zeros

from derive.emit.kernels.arithmetic import epsilon, pi
from derive.emit.kernels.array_arithmetic import each_any_of
from derive.emit.kernels.block_dips import by_dips
from derive.emit.kernels.block_places import in_time
from derive.emit.kernels.block_records import rows
from derive.emit.kernels.ground_each import clamp_in_each, level_ground_each, ridge_at_each, ridge_ground_each
from derive.emit.kernels.landscape_each import (
    has_second_pair_each,
    oblique_alone_each,
    oblique_double_each,
    oblique_single_each,
)
from derive.emit.kernels.levels_each import ridge_fall_each
from derive.emit.kernels.pieces_each import ranges_each
from derive.emit.kernels.rests_each import mirror_landscape_each
from derive.emit.kernels.symmetric_landscapes_each import (
    no_field_each,
    orthogonal_double_each,
    orthogonal_single_each,
    parallel_alone_each,
    parallel_double_each,
    parallel_single_each,
)


class Rods(NamedTuple):
    """Rods in their own units of length: see ``equilibria.Rod``. case: their number in the block; slow: ℓ√(β + η)."""

    case: Any
    side: Any
    scale: Any
    beta: Any
    eta: Any
    length: Any
    clamp_angle: Any
    field_angle: Any
    slow: Any


class Group(NamedTuple):
    """Ranges of one kind, one a rod. turns: whole turns of the clamp; rank: among the rod's ranges, from low to high.

    dip: the place around which a ridge that is not quite there slows the motion down, or None for all of them.
    """

    rods: Rods
    turns: Any
    rank: Any
    piece: Any
    dip: Any


class Straight(NamedTuple):
    """Rods whose clamp angle is a direction without moment."""

    rods: Rods
    rest: Any


def groups(rods):
    """The ranges of tips below the clamp angle, the straight rods, and the cases that are left to the scalar solver."""
    found, straight, doubtful = [], [], [zeros(0, dtype=int)]
    for some, scene in by_landscape(rods):
        clamp = clamp_in_each(scene.rests, some.clamp_angle)
        for rest, offset in zip(scene.rests, clamp.offsets, strict=True):
            flat = flatnonzero((offset == 0) & (some.side > 0))
            if flat.size:
                straight.append(Straight(rows(some, flat), rows(rest, flat)))
        ground, low = ground_of_kind(some, scene, clamp)
        doubtful.append(some.case[low])
        for rank, (here, build) in enumerate(ranges_each(ground)):
            which = flatnonzero(here & ~low)
            if which.size:
                given, piece = rows(some, which), build(rows(ground, which))
                group = Group(given, clamp.turns[which], full(which.shape, rank), piece, None)
                parts, sharp = by_dips(group, in_time(given, piece))
                found += parts
                doubtful.append(sharp)
    return found, straight, concatenate(doubtful)


def by_landscape(rods):
    """The rods in groups with landscapes of one kind, and those."""
    beta, eta, angle = rods.beta, rods.eta, rods.field_angle
    free, strong = eta == 0, eta > beta
    along, across = ~free & (angle == 0), ~free & (angle == pi / 2)
    if each_any_of(free):
        bare = chosen(rods, free)
        yield bare, no_field_each(bare.beta)
    if each_any_of(along):
        yield from along_force(chosen(rods, along))
    if each_any_of(across & strong):
        double = chosen(rods, across & strong)
        yield double, orthogonal_double_each(double.beta, double.eta)
    if each_any_of(across & ~strong):
        single = chosen(rods, across & ~strong)
        yield single, orthogonal_single_each(single.beta, single.eta)
    slanted = ~free & (angle != 0) & (angle < pi / 2)
    if each_any_of(slanted):
        yield from inclined(chosen(rods, slanted))


def along_force(rods):
    """``by_landscape`` of rods with the field along the force."""
    strong, alone = rods.eta > rods.beta, rods.beta == 0
    if each_any_of(alone):
        field = chosen(rods, alone)
        yield field, parallel_alone_each(field.eta)
    if each_any_of(strong & ~alone):
        double = chosen(rods, strong & ~alone)
        yield double, parallel_double_each(double.beta, double.eta)
    if each_any_of(~strong & ~alone):
        single = chosen(rods, ~strong & ~alone)
        yield single, parallel_single_each(single.beta, single.eta)


def inclined(rods):
    """``by_landscape`` of rods with the field at an angle: a rod and its mirror image have one landscape for both."""
    _, one, which = unique(rods.case, return_index=True, return_inverse=True)
    loads = rows(rods, one)
    loads = loads._replace(field_angle=abs(loads.field_angle))
    for found, scene in oblique_landscapes(loads):
        number = full(one.shape, -1)
        number[found] = arange(found.size)
        place = number[which]
        for side in (1, -1):
            some = flatnonzero((place >= 0) & (side * rods.field_angle > 0))
            if some.size:
                yield rows(rods, some), facing(rows(scene, place[some]), side)


def oblique_landscapes(loads):
    """The numbers of the loads with landscapes of one kind, and those."""
    alone = loads.beta == 0
    if each_any_of(alone):
        found, field = numbered(loads, alone)
        yield found, oblique_alone_each(field.eta, field.field_angle)
    if each_any_of(~alone):
        pair = has_second_pair_each(loads.beta, loads.eta, loads.field_angle)
        if each_any_of(~alone & pair):
            found, double = numbered(loads, ~alone & pair)
            yield found, oblique_double_each(double.beta, double.eta, double.field_angle)
        if each_any_of(~alone & ~pair):
            found, single = numbered(loads, ~alone & ~pair)
            yield found, oblique_single_each(single.beta, single.eta, single.field_angle)


def numbered(rods, mask):
    """The numbers of some of the rods, and those, by a mask or by one truth value for all of them."""
    which = flatnonzero(full(rods.case.shape, mask))
    return which, rows(rods, which)


def facing(scene, side):
    """The landscape, or its mirror image for side −1."""
    return scene if side > 0 else mirror_landscape_each(scene)


def chosen(rods, mask):
    """Some of the rods, by a mask, or by one truth value for all of them."""
    return numbered(rods, mask)[1]


def ground_of_kind(rods, scene, clamp):
    """The ground of rods with one kind of landscape, and where a ridge is too near the hill's level to be told."""
    rests = scene.rests
    if len(rests) == 3 or scene.level:
        return level_ground_each(rods.eta, scene, clamp.offsets), zeros(rods.case.shape, dtype=bool)
    drop = ridge_fall_each(rods.beta, rods.eta, rods.field_angle, rests[0], rests[2])
    low = drop <= epsilon() ** 17 * (rods.beta + rods.eta)
    ridge = ridge_at_each(rods.beta, rods.eta, rods.field_angle, rests, drop)
    return ridge_ground_each(rods.eta, scene, clamp.offsets, ridge), low
