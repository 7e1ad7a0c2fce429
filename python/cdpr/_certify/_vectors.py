"""Vectors, of floats or of fractions."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import Any, TypeAlias, TypeVar

Vector: TypeAlias = tuple[float, float, float]
Exact: TypeAlias = tuple[Fraction, Fraction, Fraction]
N = TypeVar("N", float, Fraction)

ON_SURFACE = 1e-7  # m: a point this close to a body lies on it, a body this thin is flat, the shortest cable
# m: ends of cables this close are one point, as in the definition of a scene: such a pair of cables touches by
# construction and forbids nothing, and cables that all end there exert no moments. A larger value would prove less, a
# smaller one would call positions forbidden that are free. crates/cdpr-certify has the same value.
SAME_END = 1e-7
COPLANAR = 1e-9  # m: a point this far from a plane still lies in it


def or_default(value: Any, default: Any) -> Any:
    return default if value is None else value


def exact(p: Sequence[Any]) -> Exact:
    return Fraction(p[0]), Fraction(p[1]), Fraction(p[2])


def plus(p: Exact, q: Exact) -> Exact:
    return p[0] + q[0], p[1] + q[1], p[2] + q[2]


def minus(p: tuple[N, N, N], q: tuple[N, N, N]) -> tuple[N, N, N]:
    return p[0] - q[0], p[1] - q[1], p[2] - q[2]


def scaled(p: Exact, s: Fraction | int) -> Exact:
    return p[0] * s, p[1] * s, p[2] * s


def interpolated(p: Exact, q: Exact, s: Fraction) -> Exact:
    return plus(p, scaled(minus(q, p), s))


def dot(p: tuple[N, N, N], q: tuple[N, N, N]) -> N:
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]


def squared(p: tuple[N, N, N]) -> N:
    return dot(p, p)


def cross(p: tuple[N, N, N], q: tuple[N, N, N]) -> tuple[N, N, N]:
    return p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]


def root_of(x: Fraction, up: int) -> Fraction:
    """Return the square root, rounded down (0) or up (1) at about its 64th binary digit."""
    shift = max(0, 65 + (x.denominator.bit_length() - x.numerator.bit_length()) // 2)
    return Fraction(math.isqrt((x.numerator << 2 * shift) // x.denominator) + up, 1 << shift)
