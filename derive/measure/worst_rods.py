"""Rods on which solvers were worst, as data: found by searches, with what makes them hard."""

from __future__ import annotations

from math import pi

GENERIC = 0.7  # an angle of the field that is near nothing
# β, η, length, clamp, field angle, and what the atlas saw there.
ATLAS = (
    (6.309573444801944, 1e4, 1.0, 3 * pi / 4, 0.0, "tips at the level of a ridge within rounding"),
    (1.0, 1e4, 1.0, 3 * pi / 4, 0.0, "tips at the level of a ridge within rounding"),
    (6.309573444801944, 1e4, 1.0, 3 * pi / 4, GENERIC, "tips at the level of a ridge within rounding"),
    (1e4, 0.0039810717055349856, 1.0, 3 * pi / 4, 0.0, "a long rod, next to no field"),
    (2.511886431509582e-06, 1e4, 1.0, 3 * pi / 4, 0.0, "a long rod, next to no force"),
    (1e4, 1.5848931924611091e-09, 1.0, 3 * pi / 4, GENERIC, "a long rod, next to no field"),
    (0.8, 0.2, 6.0, 3.1415926535897927, 0.0, "the clamp one rounding off the hill"),
    (0.35, 0.5340101894795135, 7.0, 2.0, GENERIC, "1e-14 of η from a fold"),
    (14.4, 21.6, 1.0, -1.3463968515384828, -0.2243994752564138, "the worst of all directions of clamp and field"),
    (14.4, 21.6, 1.0, 1.8849555921538759, pi / 2, "the field across the force: places of rods that turn back"),
    (14.4, 21.6, 1.0, -1.8849555921538759, 0.9424777960769379, "places of rods that turn back"),
    (0.35, 0.7095286540009907, 7.0, 2.0, GENERIC, "beside a fold of an inclined field"),
    (0.35, 0.48060917053156693, 7.0, 2.0, GENERIC, "a tenth of η before a fold of an inclined field"),
    (0.6, 0.0, 6.0, 3.6610231870869936, 0.0, "the energy of a rod in a force alone"),
    (0.046415888336127725, 1e4, 1.0, 3 * pi / 4, GENERIC, "the energy of a long rod"),
    (1e4, 2.1544346900318822e-07, 1.0, 3 * pi / 4, 0.0, "the energy of a long rod"),
    (2.1544346900318822e-07, 0.046415888336127725, 1.0, 3 * pi / 4, GENERIC, "the energy of a short rod"),
    (1e-300, 1e-12, 1.0, 3 * pi / 4, GENERIC, "the energy of a short rod"),
    (0.35, 0.5874112084274707, 7.0, 2.0, GENERIC, "angles beyond 4 beside a fold of an inclined field"),
    (14.4, 21.599999999999998, 1.0, 1.8849555921538759, 0.3141592653589793, "angles beyond 4"),
    (14.4, 21.599999999999998, 1.0, -0.7853981633974483, 0.39269908169872414, "angles beyond 4"),
    (14.4, 21.599999999999998, 1.0, 1.8849555921538759, 0.9424777960769379, "angles beyond 4"),
)

# β, η, length, clamp, field angle of random rods that were off by more than a bound once, and what lost the digits.
SEARCHED = (
    (0.691266117335185, 0.5726458934943423, 6.0, 1.341751913558821, -0.7804322662658351, "it ends on its way back"),
    (14.4, 21.599999999999998, 1.0, pi / 2, -pi / 4, "it ends on its way back"),
    (0.02289525907946422, 2.466458022862686, 6.0, 2.005051496786905, -1.281631813932706, "it ends on its way back"),
    (1.22042641897949e-06, 0.013110449379058928, 62.10165243122647, 0.16945454331890053, 0.0, "it turns by the clamp"),
    (0.020281194832973297, 1.331576919774803, 6.0, 2.8706958009280994, 0.0, "it turns by the clamp"),
    (
        0.021759710435278246,
        5.457176303595312e-07,
        56.290029253704276,
        1.2760460069714554,
        0.0,
        "it nearly passes a hill",
    ),
    (1.3179496624992515, 0.0, 6.0, pi / 2, 0.0, "it nearly passes a hill"),
    (67.57473859909362, 0.0, 1.0, -1.9834414736195871, 0.0, "parts of its energy cancel"),
    (
        0.00047974387258473215,
        0.001432109517943898,
        6.0,
        pi / 2,
        -0.8009558245966886,
        "short: parts of its energy cancel",
    ),
    (0.000754671640535097, 0.014487098844292296, 80.0, pi / 2, -1.2433229141628492, "it rests all but along the field"),
    (0.01127428842351085, 0.0, 80.0, 8.328035738336919, 0.0, "the clamp is more than a turn on"),
    (
        2.4302721766809614,
        3.8753057206158164,
        1.580704486732356,
        5.4798047179104055,
        1.3281065623067299,
        "a ridge and a well all but merge",
    ),
    (
        0.3839532844316139,
        0.3839534601887917,
        0.8816052193177799,
        3.141592653484441,
        -6.663962624344102e-12,
        "a ridge and two wells all but merge",
    ),
    (
        0.5914372585118508,
        0.5914372767167682,
        13.524285715353868,
        2.6662662871386704,
        1.6487517190980542e-12,
        "a ridge and two wells all but merge",
    ),
    (
        0.22052893709243976,
        0.3556920441718754,
        49.796891218733386,
        5.4639559212560975,
        1.3184064099545527,
        "it passes a ridge that all but merges with a well",
    ),
    (
        0.44299240882890556,
        0.44262285167088655,
        29.00604296951599,
        3.141592681532727,
        8.936006726329793e-12,
        "a flat well: directions all but merge",
    ),
    (0.97813, 1.868753805187402, 11.81, 5.060506112648607, 1.0438, "it rests beside a shoulder"),
    (0.34079, 0.53332, 151.08, 3.91, 0.22171, "it rests beside a shoulder, and is long"),
    (0.26411, 0.33792820384301364, 217.81, 3.2208778211365914, 1.494, "it turns beside a shoulder, and is long"),
    (0.70033, 0.7660079913322464, 47.68, -0.4496269890614091, 1.5555, "it turns by the clamp below a ridge"),
    (0.74293, 1.288991764283335, 115.97, 4.100400136067098, 0.34226, "it turns in a well beside a low ridge"),
)
