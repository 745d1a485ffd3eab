"""Axes to draw on, for the tests of figures."""

from arenite.figures import saving


def axes():
    return saving.Canvas().add_subplot()
