"""Elliptical Hertz contact from the textbook (K. L. Johnson, Contact Mechanics, ch. 4): independent of the program."""

import math


def elliptic(m):
    """Complete integrals K and E of the parameter m = k^2, by arithmetic-geometric means."""
    a, g, c, total, power = 1.0, math.sqrt(1.0 - m), math.sqrt(m), 0.0, 0.5
    while True:
        total += power * c * c
        if abs(c) < 1e-17:
            break
        a, g, c, power = 0.5 * (a + g), math.sqrt(a * g), 0.5 * (a - g), power * 2.0
        if power > 1e6:
            break
    k = math.pi / (2.0 * a)
    return k, k * (1.0 - total)


def point(load, curvature_a, curvature_b, modulus):
    """Half axes (large, small), peak pressure and approach. curvature_a: sum of curvatures in the plane of the large axis, curvature_b of the
    small axis [1/m]; modulus: 1 / ((1 - n1^2)/E1 + (1 - n2^2)/E2)."""
    low, high = 0.0, 1.0 - 1e-14
    wanted = curvature_a / curvature_b

    def ratio(e2):  # A/B as a function of the square of the eccentricity
        k, e = elliptic(e2)
        n = 1.0 - e2  # (b/a)^2
        return (k - e) / (e / n - k)

    for _ in range(200):
        mid = 0.5 * (low + high)
        if ratio(mid) > wanted:
            low = mid
        else:
            high = mid
    e2 = 0.5 * (low + high)
    k, e = elliptic(e2)
    n = 1.0 - e2
    b_sum = 0.5 * curvature_b
    # B = p0/E* b/a^2 ... with p0 = 3 Q / (2 pi a b): a^3 = 3 Q (E/n - K) / (2 pi E* B e^2) (Johnson 4.26)
    a = (3.0 * load * (e / n - k) / (2.0 * math.pi * modulus * b_sum * e2)) ** (1.0 / 3.0)
    b = a * math.sqrt(n)
    p0 = 1.5 * load / (math.pi * a * b)
    return a, b, p0, p0 / modulus * b * k


def stiffness(curvature_a, curvature_b, modulus):
    """K of Q = K d^1.5."""
    delta = point(1.0, curvature_a, curvature_b, modulus)[3]
    return delta**-1.5


STEEL = 207e9 / (1.0 - 0.29**2) / 2.0


def ball_on_race(load, diameter, pitch, factor, angle, race, modulus=STEEL):
    gamma = diameter * math.cos(angle) / pitch
    rolling = 2.0 / diameter + (2.0 / diameter) * (gamma / (1.0 - gamma) if race == 2 else -gamma / (1.0 + gamma))
    across = 2.0 / diameter - 1.0 / (factor * diameter)
    return point(load, across, rolling, modulus)


def line(load_per_length, curvature, modulus=STEEL):
    """Half width and peak pressure of a line contact."""
    half = math.sqrt(4.0 * load_per_length / (math.pi * modulus * curvature))
    return half, 2.0 * load_per_length / (math.pi * half)


def lame_pressure(interference, radius, inner, outer, inner_part, outer_part):
    """Diametral interference of two rings; parts (E, nu)."""
    (e1, n1), (e2, n2) = inner_part, outer_part
    soft_in = ((radius**2 + inner**2) / (radius**2 - inner**2) - n1) / e1
    soft_out = ((outer**2 + radius**2) / (outer**2 - radius**2) + n2) / e2
    return interference / (2.0 * radius * (soft_in + soft_out))
