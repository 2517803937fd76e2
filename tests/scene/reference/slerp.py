"""The factors of spherical linear interpolation: the float64 nearest to the real numbers.

Everything is computed with DIGITS decimal digits and rounded once, at the end, by float(). That is the nearest number
unless the real one lies within about 10^-(DIGITS - 30) of the middle between two of them.
"""
import math
from decimal import Decimal, localcontext

DIGITS = 120
SMALL = Decimal(10) ** -(DIGITS - 10)


def sine(x):
    """Taylor: x - x^3/3! + x^5/5! - ..."""
    return alternating_series(x, x, 1)


def cosine(x):
    """Taylor: 1 - x^2/2! + x^4/4! - ..."""
    return alternating_series(x, Decimal(1), 0)


def alternating_series(x, term, power):
    total = Decimal(0)
    while abs(term) > SMALL * abs(x):
        total += term
        term = -term * x * x / ((power + 1) * (power + 2))
        power += 2
    return total


def arc_cosine(c):
    """Newton's method on cos(a) = c, 0 <= c < 1, from the guess of the machine's own library."""
    a = Decimal(math.acos(float(c)))
    while True:
        step = (cosine(a) - c) / sine(a)
        a += step
        if abs(step) < a * SMALL * 10**20:
            return a


def factors(c, u):
    """sin((1-u)a)/sin(a) and sin(ua)/sin(a), a = arccos c, of float64 numbers 0 <= c < 1 and 0 < u < 1."""
    with localcontext() as context:
        context.prec = DIGITS
        a, u = arc_cosine(Decimal(c)), Decimal(u)
        return float(sine((1 - u) * a) / sine(a)), float(sine(u * a) / sine(a))


def slerp(q0, q1, u):
    """From q0 to q1 by the shorter way."""
    c = ((q0[0] * q1[0] + q0[1] * q1[1]) + q0[2] * q1[2]) + q0[3] * q1[3]
    s = -1.0 if c < 0 else 1.0
    k0, k1 = (1 - u, u) if abs(c) >= 1 else factors(abs(c), u)
    return tuple(k0 * a + k1 * (s * b) for a, b in zip(q0, q1))
