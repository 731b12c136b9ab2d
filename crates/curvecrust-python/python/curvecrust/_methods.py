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
    """Whether it can use which points are ends of open curves."""
    takes_shape: bool
    """Whether it can use that curves are closed or open, and how many there are."""
    made_for: str
    """The kinds of curves that it is made for, such as 'closed, several'."""
    argued: bool
    """Whether its definition follows what others wrote of a publication that was not available."""


def methods() -> list[Method]:
    """Return all methods, the default first.

    >>> import curvecrust
    >>> curvecrust.methods()[0].name
    'least-detour'
    """
    return [Method(**{**entry, "guarantees": tuple(entry["guarantees"])}) for entry in _methods()]
