"""A water lily on a pond: twelve rows of four petals along a spiral, stamens, pads and the water.

It is modelled as a bud. Each row has two targets, lift_NN and open_NN, NN from 01 outside to 12 inside: the first and
the second half of a petal's way, so that it is open where both are 1. "spread" opens the stamens."""

import math

from gltf_file import GltfFile

ROWS, PETALS_A_ROW = 12, 4
GOLDEN_ANGLE = math.radians(180 * (3 - math.sqrt(5)))  # between a petal and the next, as plants have it
STAMENS = 26

WHITE, PINK, GREEN = (0.93, 0.86, 0.84), (0.80, 0.22, 0.38), (0.16, 0.30, 0.08)
YELLOW, ORANGE = (0.95, 0.66, 0.08), (0.85, 0.30, 0.03)
PAD_MIDDLE, PAD_RIM = (0.10, 0.26, 0.07), (0.04, 0.13, 0.05)
WATER_NEAR, WATER_FAR = (0.018, 0.085, 0.105), (0.004, 0.018, 0.035)

PADS = [  # centre, radius, where the notch is in degrees
    ((-1.30, 0.022, 0.55), 0.72, 75),
    ((1.25, 0.020, 0.72), 0.60, 290),
    ((0.95, 0.024, -1.25), 0.78, 200),
    ((-1.05, 0.021, -1.30), 0.55, 130),
    ((0.05, 0.018, 1.75), 0.42, 20),
    ((-2.50, 0.020, -0.50), 0.50, 60),
    ((2.40, 0.020, -0.35), 0.55, 250),
]


def mix(a, b, t):
    return tuple(x + (y - x) * t for x, y in zip(a, b))


class Pose:
    """How a petal stands. Angles are from the upright axis, in degrees: at its foot, and how much more at its tip."""

    def __init__(self, foot, bend, hollow, radius):
        self.foot, self.bend = foot, bend
        self.hollow = hollow  # curvature across, 1 / length; of a bud that of the circle around the axis
        self.radius = radius  # of the foot

    def halfway(self, other):
        return Pose(*[(a + b) / 2 for a, b in zip(vars(self).values(), vars(other).values())])


class Blade:
    """A petal: a grid of points along its middle line and across."""

    def __init__(self, length, width, columns, rows, blunt=0.55):
        self.length, self.width, self.blunt = length, width, blunt
        self.columns, self.rows = columns, rows

    def half_width(self, s):
        """At s from the foot, 0, to the tip, 1: widest a little beyond the middle, with a pointed end."""
        shape = (s + 0.08) ** 0.75 * max(1 - s, 0.0) ** self.blunt
        widest = 0.75 / (0.75 + self.blunt) * 1.08 - 0.08
        return self.width * max(shape / ((widest + 0.08) ** 0.75 * (1 - widest) ** self.blunt), 0.03)

    def parameters(self):
        """Places along and across, closer to each other towards the tip, where the outline bends."""
        along = [1 - (1 - j / (self.rows - 1)) ** 1.6 for j in range(self.rows)]
        return [(s, 2 * i / (self.columns - 1) - 1) for s in along for i in range(self.columns)]

    def middle(self, pose, s):
        """Radius, height and angle from upright of the middle line, which is an arc."""
        foot, bend = math.radians(pose.foot), math.radians(pose.bend)
        angle = foot + bend * s
        if abs(bend) < 1e-6:
            return pose.radius + self.length * s * math.sin(foot), self.length * s * math.cos(foot), angle
        arc = self.length / bend
        return pose.radius + arc * (math.cos(foot) - math.cos(angle)), arc * (math.sin(angle) - math.sin(foot)), angle

    def point(self, pose, around, height, s, t):
        radius, y, angle = self.middle(pose, s)
        across = t * self.half_width(s)
        turn = pose.hollow * across
        sideways = math.sin(turn) / pose.hollow
        inwards = (1 - math.cos(turn)) / pose.hollow
        # Inwards is across the middle line, towards the axis and upwards.
        radius -= inwards * math.cos(angle)
        y += inwards * math.sin(angle)
        return (radius * math.sin(around) + sideways * math.cos(around), height + y,
                radius * math.cos(around) - sideways * math.sin(around))

    def normal(self, pose, around, height, s, t):
        """Of the inner side, from differences."""
        h = 1e-4

        def point(s, t):
            return self.point(pose, around, height, s, t)

        along = minus(point(min(s + h, 1.0), t), point(max(s - h, 0.0), t))
        side = minus(point(s, t + h), point(s, t - h))
        return unit(cross(side, along))

    def triangles(self, first):
        """Counter-clockwise seen from the inner side."""
        result = []
        for j in range(self.rows - 1):
            for i in range(self.columns - 1):
                a = first + j * self.columns + i
                b, c, d = a + 1, a + self.columns, a + self.columns + 1
                result += [(a, b, d), (a, d, c)] if i < self.columns // 2 else [(a, b, c), (b, d, c)]
        return result


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return [x / length for x in v]


class Lily:
    """Arrays of the mesh, and the rows of the targets."""

    def __init__(self):
        self.positions, self.normals, self.colors, self.triangles = [], [], [], []
        self.rows = []  # of each: vertices, and their points and normals in each pose

    def begin_row(self, poses):
        self.rows.append(([], [([], []) for _ in range(poses)]))

    def add_blade(self, blade, poses, around, height, color):
        vertices, states = self.rows[-1]
        first = len(self.positions)
        for s, t in blade.parameters():
            vertices.append(len(self.positions))
            for pose, (points, normals) in zip(poses, states):
                points.append(blade.point(pose, around, height, s, t))
                normals.append(blade.normal(pose, around, height, s, t))
            self.positions.append(states[0][0][-1])
            self.normals.append(states[0][1][-1])
            self.colors.append(color(s, t))
        self.triangles += blade.triangles(first)

    def add_disc(self, centre, radii, color, rim=0.0, notch=0, turned=0):
        """Rings around a point. The outermost one stands up by `rim`; `notch` degrees are cut out at `turned`, and the
        outline is ruffled then."""
        sides = 40
        first = len(self.positions)
        for radius in radii:
            outermost = radius == radii[-1]
            lean = 0.35 if outermost and rim else 0.0
            for i in range(sides + 1):
                angle = math.radians(turned + notch / 2 + (360 - notch) * i / sides)
                ruffled = radius * (1 + (0.02 * math.sin(7 * angle + centre[0]) if notch else 0))
                x, z = math.sin(angle), math.cos(angle)
                self.positions.append((centre[0] + ruffled * x, centre[1] + rim * outermost, centre[2] + ruffled * z))
                self.normals.append(unit([-lean * x, 1, -lean * z]))
                self.colors.append(color(radius / radii[-1]))
        for j in range(len(radii) - 1):
            for i in range(sides):
                a = first + j * (sides + 1) + i
                b, c, d = a + 1, a + sides + 1, a + sides + 2
                self.triangles += [(a, c, d), (a, d, b)] if radii[j] > 0 else [(a, c, d)]


def petal_color(inside):
    """Of the outermost row, the sepals, green along the middle; of the others pink at the foot, paler inside."""
    foot = mix(WHITE, PINK, 0.35 + 0.45 * (1 - inside))

    def sepal(s, t):
        return mix(GREEN, WHITE, 0.15 + 0.6 * abs(t) * s)

    def petal(s, t):
        return mix(foot, WHITE, min(1, 0.25 + 0.9 * s) * (0.45 + 0.4 * inside))

    return petal if inside > 0 else sepal


def add_petals(lily):
    for row in range(ROWS):
        inside = row / (ROWS - 1)
        lily.begin_row(3)
        for petal in range(PETALS_A_ROW):
            number = row * PETALS_A_ROW + petal
            around = number * GOLDEN_ANGLE
            inner = number / (ROWS * PETALS_A_ROW - 1)
            blade = Blade(length=1.02 - 0.46 * inner, width=0.27 - 0.12 * inner, columns=5, rows=8)
            bud = Pose(30 - 12 * inner, -52 + 22 * inner, hollow=2.6 + 2.2 * inner, radius=0.10 - 0.05 * inner)
            open_ = Pose(88 - 44 * inner**1.2, -24 - 4 * inner, hollow=1.5, radius=0.16 - 0.06 * inner)
            poses = [bud, bud.halfway(open_), open_]
            lily.add_blade(blade, poses, around, 0.06 + 0.10 * inner, petal_color(inside))


def add_stamens(lily):
    lily.begin_row(2)
    for number in range(STAMENS):
        inner = number / (STAMENS - 1)
        blade = Blade(length=0.30 - 0.08 * inner, width=0.022, columns=3, rows=4, blunt=0.3)
        closed = Pose(foot=4, bend=-6, hollow=4.0, radius=0.075 - 0.055 * inner)
        spread = Pose(foot=42 - 30 * inner, bend=-28, hollow=4.0, radius=0.085 - 0.06 * inner)
        lily.add_blade(blade, [closed, spread], number * GOLDEN_ANGLE, 0.16, lambda s, t: mix(ORANGE, YELLOW, s))


def add_pond(lily):
    # What the petals stand on, the pads, and the water below them all.
    lily.add_disc((0, 0.05, 0), [0, 0.1, 0.18], lambda r: mix(GREEN, PAD_RIM, r), rim=0.04)
    for centre, radius, turned in PADS:
        rings = [0, 0.5 * radius, 0.93 * radius, radius]
        lily.add_disc(centre, rings, lambda r: mix(PAD_MIDDLE, PAD_RIM, r**2), rim=0.03, notch=16, turned=turned)
    lily.add_disc((0, 0, 0), [0, 1.5, 4, 20], lambda r: mix(WATER_NEAR, WATER_FAR, min(1, 4 * r)))


def write(path):
    lily = Lily()
    add_petals(lily)
    add_stamens(lily)
    add_pond(lily)

    file = GltfFile()
    attributes = {
        "POSITION": file.vectors(lily.positions),
        "NORMAL": file.vectors(lily.normals),
        "COLOR_0": file.colors(lily.colors),
    }
    targets, names = [], []
    for number, (vertices, states) in enumerate(lily.rows):
        moved = file.view(vertices, "H")
        steps = [f"{step}_{number + 1:02}" for step in ("lift", "open")] if number < ROWS else ["spread"]
        for step, (before, after) in zip(steps, zip(states, states[1:])):
            target = {}
            for attribute, old, new in zip(("POSITION", "NORMAL"), before, after):
                rows = [minus(q, p) for p, q in zip(old, new)]
                target[attribute] = file.displacements(len(lily.positions), moved, rows)
            targets.append(target)
            names.append(step)
    primitive = {"attributes": attributes, "indices": file.indices(lily.triangles), "targets": targets}
    file.write(path, primitive, names, {"doubleSided": True})
