"""The methods by their names."""

from __future__ import annotations

from dataclasses import dataclass

from ._curvecrust import methods as _methods


@dataclass(frozen=True)
class Method:
    """What is known of a method of reconstruction."""

    name: str
    """What `reconstruct` calls it."""
    citation: str
    """Where it was published."""
    guarantees: tuple[str, ...]
    """Sampling conditions under which it is claimed to be correct for closed smooth curves."""
    cost: str
    """The time that it takes for n points."""
    takes_termini: bool
    """Whether it can be told which points are ends of open curves."""


def methods() -> list[Method]:
    """Return all methods, the default first.

    >>> import curvecrust
    >>> curvecrust.methods()[0].name
    'least-detour'
    """
    return [Method(**{**entry, "guarantees": tuple(entry["guarantees"])}) for entry in _methods()]
