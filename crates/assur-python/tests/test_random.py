"""Random input: an answer or an exception of Python, and never a crash."""

from __future__ import annotations

import numpy as np
import pytest

import assur

hypothesis = pytest.importorskip("hypothesis")
from hypothesis import given, settings  # noqa: E402
from hypothesis import strategies as st  # noqa: E402
from hypothesis.extra import numpy as arrays  # noqa: E402

ANY = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(),
    st.floats(),
    st.text(max_size=5),
    st.lists(st.one_of(st.floats(), st.integers(), st.none(), st.text(max_size=2)), max_size=4),
    arrays.arrays(arrays.scalar_dtypes(), arrays.array_shapes(max_dims=3, max_side=4)),
)
NAMES = st.one_of(st.sampled_from(["r", "r [mm]", "l [m]", "variant", "phi", "phi [N]"]), st.text(max_size=6))
EXPECTED = (ValueError, TypeError, OverflowError)


@pytest.fixture(scope="module")
def problem(engine: str) -> assur.Problem:
    return assur.compile(engine)


@settings(max_examples=150, deadline=None)
@given(positions=st.one_of(ANY, st.dictionaries(st.sampled_from(["crank", "rod", ""]), ANY, max_size=2)))
def test_positions(problem: assur.Problem, positions: object) -> None:
    try:
        solution = problem.solve(positions)
    except EXPECTED as error:
        assert str(error)
        return
    assert all(len(solution[name]) == len(solution) for name in solution)


@settings(max_examples=150, deadline=None)
@given(table=st.dictionaries(NAMES, ANY, max_size=3))
def test_rows(problem: assur.Problem, table: dict) -> None:
    try:
        answers = problem.batch(table).read()
    except EXPECTED as error:
        assert str(error)
        return
    assert all(len(answers[name]) == len(answers) for name in answers)
    assert all(line or not np.isnan(mb) for line, mb in zip(answers["error"], answers["Mb"]))


@settings(max_examples=100, deadline=None)
@given(text=st.one_of(st.text(max_size=60), st.binary(max_size=40).map(lambda b: b.decode("utf-8", "surrogateescape"))))
def test_texts(text: str) -> None:
    for call in (lambda: assur.compile(text).solve(), lambda: assur.format(text), lambda: assur.grade(text + "\n", text + "\n")):
        try:
            call()
        except EXPECTED as error:
            assert isinstance(error, ValueError)


@settings(max_examples=50, deadline=None)
@given(values=st.dictionaries(st.sampled_from(["r", "l", "q", "\ud800"]), ANY, max_size=2))
def test_values(engine: str, values: dict) -> None:
    try:
        assur.compile(engine, set=values)
    except EXPECTED as error:
        assert str(error)
