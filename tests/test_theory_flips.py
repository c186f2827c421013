"""The derivation checks itself: a sign flipped in any line of a theory script breaks a claim, or the script stops.

A fixed sample of the flips is tried here, spread over all the scripts; how, is told in flips.py. It runs as a process
of its own with a single thread, for it forks.
"""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

FLIPS = Path(__file__).parent / "flips.py"


@pytest.mark.long
def test_a_flipped_sign_breaks_a_claim():
    run = subprocess.run([sys.executable, str(FLIPS)], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    outcomes = json.loads(run.stdout)
    assert len(outcomes) >= 48
    assert not [f"{script}.py:{line}" for script, line, outcome in outcomes if not outcome]
    assert sum(outcome.startswith("refutes") for _, _, outcome in outcomes) > len(outcomes) / 2
