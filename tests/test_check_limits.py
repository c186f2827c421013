"""Time limits: whatever hangs, the verdict comes, in every thread and process; and no late alarm is left behind."""

from __future__ import annotations

import threading
import time

import pytest
import sympy as sp
from sympy import Symbol, cos, sin

from derive.check import prove
from derive.check.judge import judge, judge_all
from derive.check.timing import TimeLimit, limited
from derive.check.verdicts import AGREED, PROVED, UNKNOWN
from derive.theory.claims import Claim, Equal

x = Symbol("x", real=True)
TRUE = Equal(sin(x) ** 2 + cos(x) ** 2, 1)
LONG = 60.0  # seconds: no test would wait for it


class Endless(sp.Function):
    """An expression over which SymPy hangs."""

    def _eval_subs(self, old: sp.Expr, new: sp.Expr) -> None:
        work(LONG)


def work(seconds: float) -> None:
    """Keep the processor at it."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        pass


def hang(*arguments: object) -> str:
    work(LONG)
    return ""


def in_thread(action) -> list:
    found: list = []
    thread = threading.Thread(target=lambda: found.append(action()))
    thread.start()
    thread.join(LONG / 2)
    assert found, "the thread did not end"
    return found


def test_a_prover_that_hangs_is_ended(monkeypatch):
    monkeypatch.setattr(prove, "equal", hang)
    found = judge(Claim("test.hang", "hangs", TRUE), 0.3)
    assert found.verdict == AGREED
    assert found.reason == "no proof in 0.3 s"
    assert found.seconds < 10


def test_a_prover_that_hangs_is_ended_in_a_thread(monkeypatch):
    monkeypatch.setattr(prove, "equal", hang)
    (found,) = in_thread(lambda: judge(Claim("test.hang", "hangs", TRUE), 0.3))
    assert (found.verdict, found.reason) == (AGREED, "no proof in 0.3 s")
    monkeypatch.undo()
    (found,) = in_thread(lambda: judge(Claim("test.true", "true", TRUE), 20))
    assert found.verdict == PROVED


def test_other_claims_of_a_pool_do_not_wait():
    hanging = Claim("test.hang", "hangs", Equal(Endless(x), 1), given=((x, sp.Integer(2)),))
    claims = [hanging, *(Claim(f"test.{k}", "true", Equal(TRUE.lhs + k, 1 + k)) for k in range(5))]
    start = time.monotonic()
    found = judge_all(claims, jobs=2, seconds=2)
    assert time.monotonic() - start < LONG / 2
    assert [one.verdict for one in found] == [UNKNOWN, *[PROVED] * 5]
    assert found[0].reason == "no proof in 2 s"


def test_no_alarm_comes_late():
    def often() -> int:
        rung = 0
        for k in range(60):
            try:
                with limited(0.004):
                    work(0.001 * (k % 8))
            except TimeLimit:
                rung += 1
        time.sleep(0.05)
        return rung

    assert often() < 60
    assert in_thread(often)[0] < 60


def test_without_a_limit_nothing_is_set():
    with limited(None):
        pass
    with pytest.raises(TimeLimit, match=r"no proof in 0\.05 s"), limited(0.05):
        work(LONG)


def test_time_in_which_others_have_the_processor_does_not_count():
    with limited(0.2):
        time.sleep(0.5)


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
def test_a_limit_that_is_swallowed_by_a_finalizer_is_said_again():
    class Slow:
        def __del__(self):
            work(0.4)

    def swallow_then_work():
        Slow()  # the first alarm rings in its finalizer, where no exception gets out
        work(LONG)

    with pytest.raises(TimeLimit), limited(0.2):
        swallow_then_work()
