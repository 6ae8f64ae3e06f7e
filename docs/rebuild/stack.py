"""The solver of a stack, rebuilt from the book alone: chapters "Rigid body", "Constraint-based resolution" and
"The step and the architecture". Of collision detection only what an upright stack needs is here: the lower
corners of a box on the top of the one below. compare_stack.py compares it with the engine.
"""
import numpy as np

# The defaults of the settings, from the table of chapter "The step and the architecture".
STEP, SUBSTEPS, ITERATIONS, RELAX_ITERATIONS = 1 / 60, 6, 2, 1
HERTZ, DAMPING_RATIO, MAX_PUSH_SPEED, OVER_RELAXATION = 80, 12, 3, 1.3
GRAVITY, DENSITY, FRICTION = np.array([0, 0, -9.81]), 1000, 0.6
H = STEP / SUBSTEPS


def cross(a, b):
    """np.cross() takes ten times as long for two single vectors."""
    return np.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def turn(w):
    """The matrix of the rotation vector w (Rodrigues)."""
    angle = np.linalg.norm(w)
    if angle < 1e-12:
        return np.eye(3)
    x, y, z = w / angle
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k


class Body:
    """State x, R, P, L; derived v, w, W; displacements since the start of the step."""

    def __init__(self, half, x, v, density=DENSITY):
        self.half, self.x, self.rotation = half, x, np.eye(3)
        mass = density * 8 * np.prod(half)
        squares = half ** 2
        self.inverse_mass = 1 / mass if mass else 0
        self.inverse_inertia = np.diag(3 / (mass * (squares.sum() - squares)) if mass else np.zeros(3))
        self.mass, self.P, self.L = mass, mass * v, np.zeros(3)
        self.refresh_velocity()

    def spin(self, rotation):
        return rotation @ self.inverse_inertia @ rotation.T @ self.L

    def refresh_velocity(self):
        self.W = self.rotation @ self.inverse_inertia @ self.rotation.T
        self.v, self.w = self.inverse_mass * self.P, self.W @ self.L

    def apply_impulse(self, impulse, r):
        """P and L change by the difference; v and w follow."""
        if self.mass:
            self.P, self.L = self.P + impulse, self.L + cross(r, impulse)
            self.v, self.w = self.v + self.inverse_mass * impulse, self.w + self.W @ cross(r, impulse)

    def integrate_pose(self):
        """The implicit midpoint: three evaluations of w(exp(h w / 2) q)."""
        self.dx, self.dw = self.dx + H * self.v, self.dw + H * self.w
        self.x = self.x + H * self.v
        w = self.spin(self.rotation)
        for _ in range(3):
            w = self.spin(turn(0.5 * H * w) @ self.rotation)
        self.rotation = turn(H * w) @ self.rotation
        self.refresh_velocity()


def soft_contact(hertz, ratio):
    """Bias rate, mass scale, impulse scale."""
    omega = 2 * np.pi * hertz
    a1 = 2 * ratio + H * omega
    a2 = H * omega * a1
    a3 = 1 / (1 + a2)
    return omega / a1, a2 * a3, a3


class Contact:
    """One corner of B on the top face of A."""

    def __init__(self, a, b, corner, old):
        self.a, self.b = a, b
        self.n, self.u = a.rotation[:, 2], a.rotation[:, 0]
        self.t = cross(self.n, self.u)
        point = b.x + b.rotation @ (b.half * corner)
        self.d0 = self.n @ (point - a.x) - a.half[2]
        middle = point - 0.5 * self.d0 * self.n
        self.r_a, self.r_b = middle - a.x, middle - b.x
        self.soft = soft_contact(HERTZ, DAMPING_RATIO) if a.mass else soft_contact(2 * HERTZ, DAMPING_RATIO / 2)
        self.m = 1 / self.response(self.n, self.n)
        tangents = (self.u, self.t)
        self.m_t = np.linalg.inv([[self.response(p, q) for q in tangents] for p in tangents])
        self.sigma = np.linalg.eigvalsh(self.m_t)[0]
        self.loaded = False  # by the last warm start
        self.normal = self.n @ old.n * old.normal if old else 0
        carried = old.friction[0] * old.u + old.friction[1] * old.t if old else np.zeros(3)
        self.friction = np.array([carried @ self.u, carried @ self.t])

    def response(self, p, q):
        """p's row of J M^-1 J^T with q's."""
        return sum(body.inverse_mass * (p @ q) + cross(r, p) @ body.W @ cross(r, q)
                   for body, r in ((self.a, self.r_a), (self.b, self.r_b)))

    def velocity(self):
        a, b = self.a, self.b
        return b.v + cross(b.w, self.r_b) - a.v - cross(a.w, self.r_a)

    def separation(self):
        a, b = self.a, self.b
        return self.d0 + self.n @ (b.dx + cross(b.dw, self.r_b) - a.dx - cross(a.dw, self.r_a))

    def apply(self, impulse):
        self.a.apply_impulse(-impulse, self.r_a)
        self.b.apply_impulse(impulse, self.r_b)

    def warm_start(self):
        self.loaded = self.normal > 0
        self.apply(self.normal * self.n + self.friction[0] * self.u + self.friction[1] * self.t)

    def solve_normal(self, use_bias):
        d = self.separation()
        rate, mass_scale, impulse_scale = self.soft if d <= 0 and use_bias else (0, 1, 0)
        bias = d / H if d > 0 else max(rate * d, -MAX_PUSH_SPEED)
        mass = OVER_RELAXATION * self.m if self.loaded and not use_bias else self.m
        change = -mass_scale * mass * (self.n @ self.velocity() + bias) - impulse_scale * self.normal
        new = max(0, self.normal + change)
        self.apply((new - self.normal) * self.n)
        self.normal = new

    def solve_friction(self):
        velocity = self.velocity()
        slip = np.array([velocity @ self.u, velocity @ self.t])
        limit = FRICTION * self.normal
        new = self.friction - self.m_t @ slip
        if np.linalg.norm(new) > limit:
            new = self.friction - self.sigma * slip
            new *= min(1, limit / max(np.linalg.norm(new), 1e-30))
        change = new - self.friction
        self.apply(change[0] * self.u + change[1] * self.t)
        self.friction = new

    def solve(self, use_bias, backwards):
        if backwards:
            self.solve_friction()
        self.solve_normal(use_bias)
        if not backwards:
            self.solve_friction()


# Of the lower face of a box, in the order of its half-edges: counter-clockwise seen from below.
CORNERS = [np.array(corner) for corner in ((-1, 1, -1), (1, 1, -1), (1, -1, -1), (-1, -1, -1))]


def guess_impulses(pairs):
    """Cold start: one unknown per pair, in the middle of its points; symmetric Gauss-Seidel sweeps."""
    speed = {id(contact.b): H * GRAVITY[2] for pair in pairs for contact in pair[:1]}
    unknown, change = np.zeros(len(pairs)), np.inf
    while change > 1e-5 * H * 9.81:
        change = 0
        for i in [*range(len(pairs)), *reversed(range(len(pairs)))]:
            a, b = pairs[i][0].a, pairs[i][0].b  # the middle is below both centres: nothing turns
            mass = 1 / (a.inverse_mass + b.inverse_mass)
            new = max(0, unknown[i] - mass * (speed[id(b)] - speed.get(id(a), 0)))
            for body, sign in ((a, -1), (b, 1)):
                if body.mass:
                    speed[id(body)] += sign * (new - unknown[i]) * body.inverse_mass
                    change = max(change, abs(new - unknown[i]) * body.inverse_mass)
            unknown[i] = new
    for pair, impulse in zip(pairs, unknown):
        for contact in pair:
            contact.normal = impulse / len(pair)


def step(bodies, old, number):
    """Simulates the step with this number, counted from 0. Returns the contacts, for their impulses."""
    pairs = [[Contact(a, b, corner, old and old[4 * i + k]) for k, corner in enumerate(CORNERS)]
             for i, (a, b) in enumerate(zip(bodies, bodies[1:]))]
    if not old:
        guess_impulses(pairs)
    contacts = [contact for pair in pairs for contact in pair]
    for body in bodies:
        body.dx = body.dw = np.zeros(3)
    backwards = number % 2 == 1
    for _ in range(SUBSTEPS):
        for body in bodies[1:]:
            body.P = body.P + H * body.mass * GRAVITY
            body.refresh_velocity()
        for contact in contacts:
            contact.warm_start()
        for done in range(ITERATIONS + RELAX_ITERATIONS):
            if done == ITERATIONS:
                for body in bodies[1:]:
                    body.integrate_pose()
            for contact in reversed(contacts) if backwards else contacts:
                contact.solve(done < ITERATIONS, backwards)
    return contacts
