#!/usr/bin/python3
"""Shows that the trajectories of the reference cases depend on the shipped laws: changes one law at a time and validates.

    mutations.py SOURCE [--scratch FOLDER] [--only NAME] [--preset NAME] [--jobs N] [--check] [--report FILE]

SOURCE is a checkout, which is copied to the scratch folder and never changed. For every mutation one line of a law is replaced in the copy,
`adore` is built there, and `adore validate` runs the nine families of trajectories; then the line is restored. The table states for each family
how many of its cases fail (timeout: all). The exit code is 1 when a mutation changes no family, or a family is changed by no mutation.
--check only tests that every line to replace is in SOURCE exactly as often as stated (no building).
"""

import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

FAMILIES = ("F_dynamics", "dynamics_impact", "dynamics_plates", "dynamics_pocket", "dynamics_rigid_whirl", "dynamics_ball_vibration",
            "dynamics_ball_thrust", "dynamics_ball_radial", "dynamics_roller")

# name: (file below core/, line as it is, line as it becomes, how often it is there)
MUTATIONS = {
    "Hertz exponent 2": ("contact/ball_groove.hpp", "return K * approach * root;", "return K * approach * root * root * 400.0;", 1),
    "contact normal": ("contact/ball_groove.hpp", "touch.n_k = axial * inverse;", "touch.n_k = 0.999 * axial * inverse;", 1),
    "traction sign": ("dynamics/race_kernel_impl.hpp", "force_t = traction.F_t;", "force_t = -traction.F_t;", 1),
    "two-slope law": ("tribology/laws/two_slope.hpp", "return A + B * below + C * (slip - below);",
                      "return A + 1.01 * B * below + C * (slip - below);", 1),
    "exponential law": ("tribology/laws/exponential.hpp", "return (A + B * slip) * ScalarMath<T>::exp(-C * slip) + D;",
                        "return (A + B * slip) * ScalarMath<T>::exp(-1.01 * C * slip) + D;", 1),
    "gyroscopic term of balls": ("dynamics/ball_motion.cpp", "M_theta[i] * per_inertia - td * b.omega_r[i];",
                                 "M_theta[i] * per_inertia + td * b.omega_r[i];", 1),
    "centrifugal force": ("dynamics/ball_motion.cpp", "F_r[i] * per_mass + b.r[i] * td * td;", "F_r[i] * per_mass + 0.99 * b.r[i] * td * td;", 1),
    "mass of balls": ("dynamics/ball_motion.cpp", "const double ax = F_x[i] * per_mass;", "const double ax = 1.001 * F_x[i] * per_mass;", 1),
    "Euler's equations": ("dynamics/rigid_body.hpp", "return (moment - omega.cross(Vec3(principal.cwiseProduct(omega))))",
                          "return (moment + omega.cross(Vec3(principal.cwiseProduct(omega))))", 1),
    "mass of the cage": ("dynamics/effects/free_body.cpp", "acceleration = body.force / mass_;", "acceleration = 1.001 * body.force / mass_;", 1),
    "stiffness of a pocket beyond the cap": ("contact/conformal.hpp", "return law.load_cap + law.slope_cap * (delta - law.delta_cap);",
                                             "return law.load_cap + 1.01 * law.slope_cap * (delta - law.delta_cap);", 1),
    "radius of a pocket": ("contact/ball_pocket.hpp", "return nearest_revolved_wall_point(q, pocket.wall_radius,",
                           "return nearest_revolved_wall_point(q, pocket.wall_radius + 1e-6,", 1),
    "friction sign of pockets": ("dynamics/effects/pockets.hpp", "a.friction = a.friction_per_slip * slip;", "a.friction = -a.friction_per_slip * slip;", 1),
    "friction of guide lands": ("dynamics/effects/lands.cpp", "const Vec3 friction = friction_over_slip(friction_per_slip, N, square) * slip;",
                                "const Vec3 friction = 1.01 * friction_over_slip(friction_per_slip, N, square) * slip;", 1),
    "gravity": ("dynamics/effects/gravity.cpp", "const Vec3 weight = body.mass * gravity_;", "const Vec3 weight = 1.001 * body.mass * gravity_;", 2),
}


def check(source):
    wrong = 0
    for name, (file, old, _, times) in MUTATIONS.items():
        found = (source / "core" / file).read_text().count(old)
        if found != times:
            print(f"{name}: core/{file} has the line {found} times, not {times}: {old}")
            wrong += 1
    return wrong


def copy_of(source, folder):
    """Tracked files alone: a build folder in the checkout stays out."""
    names = subprocess.run(["git", "-C", source, "ls-files", "-z"], check=True, capture_output=True).stdout.split(b"\0")
    for name in filter(None, names):
        to = folder / os.fsdecode(name)
        if (source / os.fsdecode(name)).is_file():
            to.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(source / os.fsdecode(name), to)


def build(folder, preset, jobs):
    subprocess.run(["cmake", "--build", folder / "build" / preset, "--target", "adore", f"-j{jobs}"], check=True, stdout=subprocess.DEVNULL)


def failures(folder, preset):
    """Failed cases of each family."""
    out = {}
    for family in FAMILIES:
        report = folder / "mutated.json"
        report.unlink(missing_ok=True)
        command = [folder / "build" / preset / "bin/adore", "validate", folder / f"tests/reference/{family}.json", "--report", report]
        try:
            subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=600)
            cases = json.loads(report.read_text())["files"][0]["cases"]
            out[family] = sum(one["status"] != "pass" for one in cases)
        except (subprocess.TimeoutExpired, FileNotFoundError):
            out[family] = "all"
    return out


def table(rows):
    lines = ["| changed law | " + " | ".join(one.removeprefix("dynamics_") for one in FAMILIES) + " |", "|---|" + "---|" * len(FAMILIES)]
    for name, failed in rows.items():
        lines.append(f"| {name} | " + " | ".join(str(failed[one] or "") for one in FAMILIES) + " |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("source", type=pathlib.Path)
    parser.add_argument("--scratch", type=pathlib.Path)
    parser.add_argument("--only")
    parser.add_argument("--preset", default="release")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--report", type=pathlib.Path)
    options = parser.parse_args()
    source = options.source.resolve()
    if wrong := check(source):
        return wrong
    if options.check:
        return 0
    folder = options.scratch or pathlib.Path(tempfile.mkdtemp(prefix="adore-mutations-"))
    copy_of(source, folder)
    subprocess.run(["cmake", "--preset", options.preset], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    build(folder, options.preset, options.jobs)
    rows = {"none": failures(folder, options.preset)}
    print(table(rows), flush=True)
    bad = [f"{family}: {n} cases fail without any mutation" for family, n in rows["none"].items() if n]
    for name, (file, old, new, _) in MUTATIONS.items():
        if options.only and options.only != name:
            continue
        path = folder / "core" / file
        text = path.read_text()
        path.write_text(text.replace(old, new))
        try:
            build(folder, options.preset, options.jobs)
            rows[name] = failures(folder, options.preset)
        finally:
            path.write_text(text)
        print(table(rows).splitlines()[-1], flush=True)
        if not any(rows[name].values()):
            bad.append(f"no trajectory depends on: {name}")
    if not options.only:
        bad += [f"{family}: no mutation changes it" for family in FAMILIES if not any(row[family] for row in rows.values())]
    print("\n" + table(rows))
    if options.report:
        options.report.write_text("\n".join(line for line in table(rows).splitlines()) + "\n")
    print("\n".join(bad) or "every law is seen, and every family sees one")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
