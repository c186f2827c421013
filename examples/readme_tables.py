"""Write the tables of verdicts and of wrong variants, in README.md and docs/checks.md, between their markers.

derive --json result.json && derive check --mutants --json mutants.json
python examples/readme_tables.py result.json mutants.json
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

from verdict_tables import errata_table, mutant_table, put, verdict_table

if __name__ == "__main__":
    result, mutants = (json.loads(Path(name).read_text(encoding="utf-8")) for name in sys.argv[1:3])
    put("verdicts", verdict_table(result))
    put("errata", errata_table(result))
    put("mutants", mutant_table(mutants))
