#!/usr/bin/env python3
"""Two crossed fibres, one of them struck by a projectile: the whole scheme, in NumPy.

The program speaks `crossfibre-conformance/1` (docs/conformance.md): a question a line, an answer a
line. The equations are in equations.py; here are, from top to bottom, the fibres, a step, a run, the
conversation.

A state is a dict of the protocol's form with arrays for its lists. Row i of `position` is node i;
element i lies between the nodes i and i + 1. A step makes a new state and leaves the old one alone.
"""
import json
import math
import sys

try:
    import numpy as np
except ImportError:
    sys.exit("fibres.py needs NumPy: python3 -m pip install numpy")

from equations import edition, magnitude


# ---- The fibres: what no step changes, and how they lie at rest.

class Fibre:
    """A fibre of a scene, at rest from `start` along an axis. `A` waits for the time step."""

    def __init__(self, made, start, axis):
        n, modulus = made["elements"], made["material"]["modulus"]
        self.spacing = made["length"] / n
        self.wave_speed = math.sqrt(modulus / made["density"])
        self.mass = made["density"] * made["area"] * self.spacing
        self.stiffness = modulus * made["area"]
        self.at_rest = np.tile(start, (n + 1, 1))
        self.at_rest[:, axis] += np.arange(n + 1) * self.spacing
        self.unstrained = magnitude(np.diff(self.at_rest, axis=0))

    def unmoved(self):
        return {"position": self.at_rest, "velocity": np.zeros_like(self.at_rest),
                "strain": np.zeros_like(self.unstrained), "tension": np.zeros_like(self.unstrained)}


class Problem:
    """A scene, made into fibres and a time step."""

    def __init__(self, scene):
        self.eqn = edition_of(scene)
        self.m_p = scene["projectile"].get("mass")
        self.primary = Fibre(scene["primary"], [0.0, 0.0], axis=0)
        fibres = [self.primary]
        self.start = {"step": 0, "primary": self.primary.unmoved(),
                      "projectile_velocity": scene["projectile"]["velocity"]}
        if "secondary" in scene:
            at = scene["secondary"]["at"]
            self.alpha_s = scene["secondary"]["slide_factor"]
            self.secondary = Fibre(scene["secondary"], [at, 0.0, 0.0], axis=2)
            fibres.append(self.secondary)
            node = int(np.argmin(np.abs(self.primary.at_rest[:, 0] - at)))  # the first of equals
            self.start |= {"secondary": self.secondary.unmoved(), "crossover": {"node": node, "moves": 0}}
        self.dt = scene["courant"] * min(fibre.spacing / fibre.wave_speed for fibre in fibres)
        for fibre in fibres:
            fibre.A = self.dt / fibre.mass
        self.steps = math.floor(scene["duration"] / self.dt + 0.5)


# ---- A step.

TRAVEL = np.array([0.0, 1.0])  # the projectile's direction


class Ended(Exception):
    """The run ends before its time; `state` is the last one that is whole, if this step left one."""

    def __init__(self, kind, state=None):
        super().__init__(kind)
        self.kind, self.state = kind, state


def pull(fibre):
    """The tension of each element as a vector: it has the direction of the element."""
    element = np.diff(fibre["position"], axis=0)
    return element * (fibre["tension"] / magnitude(element))[:, None]


def march(problem, fibre, before, driven, adjust=lambda v, T: None):
    """One fibre from t-1 to t; `driven` is the velocity of its first node, `adjust` may change others.

    The page goes from element to element. All that an element needs is of t-1 or is a velocity of t,
    so whole arrays give the same; and ahead of the wavefront every operation gives zero.
    """
    eqn, dt = problem.eqn, problem.dt
    x, v, T = before["position"], before["velocity"].copy(), pull(before)
    v[0], v[-1] = driven, 0.0
    v[1:-1] = eqn.eqn_2(v[1:-1], T[1:], T[:-1], fibre.A)
    adjust(v, T)
    L_before = eqn.eqn_5(x[1:], x[:-1])
    L = eqn.eqn_6(x[1:], v[1:], x[:-1], v[:-1], dt)
    strain = eqn.eqn_4(L, L_before, before["strain"], fibre.unstrained)
    tension = eqn.eqn_7(fibre.stiffness, strain)
    if not np.isfinite(tension / L).all():
        raise Ended("diverged")
    return {"position": x + v * dt, "velocity": v, "strain": strain, "tension": tension}


def feel_secondary(problem, before, v, T):
    """(15)-(18): the secondary's pull on the crossover's node, with tensions and directions of t-1."""
    eqn, ix, A = problem.eqn, before["crossover"]["node"], problem.primary.A
    x1, x2 = before["primary"]["position"], before["secondary"]["position"]
    phi1, phi2 = x1[ix] - x1[ix - 1], x2[1] - x2[0]
    phi1, phi2 = phi1 / magnitude(phi1), phi2 / magnitude(phi2)
    cosines = {"cos_phi1_x": phi1[0], "cos_phi1_y": phi1[1]}
    tension = {"T2": before["secondary"]["tension"][0], "cos_phi2_x": phi2[0], "cos_phi2_y": phi2[1]}
    du, dv = (T[ix] - T[ix - 1]) * A
    push = {"A": A, "alpha_s": problem.alpha_s, "du": du, "dv": dv, **cosines,
            "T2_para": eqn.eqn_15(**tension, **cosines), "T2_perp": eqn.eqn_16(**tension, **cosines),
            "m1": problem.primary.mass, "m2": problem.secondary.mass}
    v[ix] = eqn.eqn_17(v[ix, 0], **push), eqn.eqn_18(v[ix, 1], **push)


def follow_primary(problem, primary, ix):
    """(9)-(14): the velocity that the primary's node imposes on the secondary's first."""
    eqn, alpha_s = problem.eqn, problem.alpha_s
    velocity, theta = primary["velocity"][ix], eqn.eqn_11(*primary["position"][ix], *primary["position"][ix - 1])
    slip = alpha_s, eqn.eqn_9(*velocity, *theta), eqn.eqn_10(*velocity, *theta)
    return eqn.eqn_12(*slip, *theta), eqn.eqn_13(*slip, *theta), eqn.eqn_14()


def nearest_node(problem, primary, secondary, ix):
    """The primary's node nearest to the secondary's first, the lower of two equals.

    Nothing to look for before the wave has come to the crossover, nor where nothing slides.
    """
    if problem.alpha_s == 1.0 or not primary["tension"][:ix - 1].all():
        return ix
    first = secondary["position"][0]
    apart = primary["position"] - first[:2]
    return int(np.argmin(sum(c * c for c in apart.T) + first[2] * first[2]))


def step(problem, before):
    """One time step, in the paper's order: the primary, the projectile, the secondary, the crossover's node."""
    after = {"step": before["step"] + 1}
    v_p, crossover = before["projectile_velocity"], before.get("crossover")
    together = crossover is not None and crossover["node"] == 0  # both fibres at the impact point
    apart = crossover is not None and not together

    def adjust(v, T):
        if apart:
            feel_secondary(problem, before, v, T)

    after["primary"] = march(problem, problem.primary, before["primary"], TRAVEL * v_p, adjust)
    T_y, m_node = pull(after["primary"])[0, 1], problem.primary.mass
    if together:  # the projectile drives both fibres and feels both
        after["secondary"] = march(problem, problem.secondary, before["secondary"],
                                   [*TRAVEL * v_p, problem.eqn.eqn_14()])
        T_y, m_node = T_y + pull(after["secondary"])[0, 1], m_node + problem.secondary.mass
    if problem.m_p is not None:
        v_p = problem.eqn.eqn_8(v_p, T_y, problem.m_p, m_node, problem.dt, after["step"] * problem.dt)
        if not np.isfinite(v_p):
            raise Ended("diverged")
    after["projectile_velocity"] = v_p
    if crossover is not None:
        after["crossover"] = crossover
    if apart:
        ix = crossover["node"]
        driven = follow_primary(problem, after["primary"], ix)
        after["secondary"] = march(problem, problem.secondary, before["secondary"], driven)
        nearest = nearest_node(problem, after["primary"], after["secondary"], ix)
        if nearest in (0, len(problem.primary.unstrained)):
            raise Ended("crossover_left", after)
        if nearest != ix:
            after["crossover"] = {"node": nearest, "moves": crossover["moves"] + 1}
    return after


# ---- A run.

def run(problem):
    state, kind = problem.start, "completed"
    try:
        for _ in range(problem.steps):
            state = step(problem, state)
    except Ended as end:
        state, kind = end.state or state, end.kind
    projectile = {"velocity": state["projectile_velocity"], "position": state["primary"]["position"][0, 1]}
    result = {"format": "crossfibre-result/1", "outcome": {"kind": kind}, "steps": state["step"],
              "time": state["step"] * problem.dt, "time_step": problem.dt, "projectile": projectile}
    return result | {name: state[name] for name in ("primary", "secondary", "crossover") if name in state}


# ---- The conversation.

HELLO = {"format": "crossfibre-conformance/1", "name": "NumPy tutorial", "number": "f64",
         "depths": ["equation", "step", "run"], "laws": ["linear"], "dimensions": [2, 3],
         "strain": ["incremental", "engineering"], "corrections": ["all", "none"]}
COUNTS = ("step", "crossover")  # of a state: whole numbers


class Unsupported(Exception):
    pass


def edition_of(choice):
    """The equations that a scene, or a question about an equation, asks for."""
    found = edition(choice.get("strain", "incremental"), choice.get("corrections", "all"))
    if found is None:
        raise Unsupported("all corrections or none")
    return found


def problem_of(scene):
    for fibre in ("primary", "secondary"):
        if fibre in scene and scene[fibre]["material"].keys() != {"law", "modulus"}:
            raise Unsupported("only the linear law, without tension_only or artificial_viscosity")
    return Problem(scene)


def numbers(value):
    """Lists as arrays; "inf", "-inf" and "NaN" are numbers."""
    if isinstance(value, dict):
        return {name: value if name in COUNTS else numbers(value) for name, value in value.items()}
    return np.array(value, dtype=float)[()]  # [()]: a number alone stays one


def plain(value):
    """The way back."""
    if isinstance(value, dict):
        return {name: plain(v) for name, v in value.items()}
    if isinstance(value, (list, tuple, np.ndarray)):
        return [plain(v) for v in value]
    if isinstance(value, float) and not math.isfinite(value):
        return "NaN" if math.isnan(value) else "inf" if value > 0 else "-inf"
    return value


def answer(question):
    ask = question["ask"]
    if ask == "hello":
        return HELLO
    if ask == "equation":
        equation = getattr(edition_of(question["edition"]), "eqn_" + question["eq"])
        return {"out": equation(**numbers(question["in"]))}
    if ask == "step":
        problem, state = problem_of(question["scene"]), numbers(question["state"])
        try:
            return {"state": step(problem, state)}
        except Ended as end:
            if end.state is None:
                raise
            return {"state": end.state}
    if ask == "run":
        return {"result": run(problem_of(question["scene"]))}
    raise Unsupported(f"no {ask}")


def main():
    np.seterr(all="ignore")  # an infinite or undefined number is an answer here
    for line in sys.stdin:
        question = {}
        try:
            question = json.loads(line)
            reply = answer(question)
        except Unsupported as reason:
            reply = {"skip": str(reason)}
        except Exception as fault:  # whatever is wrong with the question: say so, and go on
            reply = {"error": f"{type(fault).__name__}: {fault}"}
        number = question.get("id") if isinstance(question, dict) else None
        print(json.dumps(plain({"id": number, **reply}), allow_nan=False), flush=True)


if __name__ == "__main__":
    main()
