"""Fills a planned study with results that nobody computed, to time `tankcheck study merge`.

    tankcheck study plan study.json --out many/
    tankcheck study run many/ --task 1
    python3 benches/study_rows.py many/
    time tankcheck study merge many/

The rows of the first task are the pattern: their utilisations and values follow the level, with a factor of the record and of the tank.
"""

import hashlib
import json
import math
import random
import sys
from pathlib import Path


def lines(task, plan, pattern):
    tank_line = next(p["tank"] for p in pattern if "tank" in p)
    rows = [p["row"] for p in pattern if "row" in p]
    for tank, sample in task["tanks"]:
        name = plan["tanks"][tank]["id"]
        yield {"tank": {**tank_line, "tank": name, "sample": sample}}
        for record in range(*task["records"]):
            chance = random.Random(f"{record}")
            strong = math.exp(chance.gauss(0, 0.3)) * math.exp(random.Random(f"t{tank}").gauss(0, 0.2))
            for level in plan["levels"]:
                row = dict(rows[0])
                part = strong * level / rows[0]["level"]
                row.update(tank=name, sample=sample, record=plan["records"][record]["id"], level=level, im=level, factor=part)
                row["values"] = {k: float(f"{v * part:.9e}") for k, v in row["values"].items()}
                row["checks"] = {
                    k: float(f"{v * part:.9e}") if isinstance(v, float) else v for k, v in row["checks"].items()
                }
                yield {"row": row}


def main(folder):
    plan = json.loads((folder / "plan.json").read_text())
    tasks = [json.loads(line) for line in (folder / "tasks.jsonl").read_text().splitlines()]
    first = folder / "results" / tasks[0]["key"][:2] / f"{tasks[0]['key']}.jsonl"
    pattern = [json.loads(line) for line in first.read_text().splitlines()[:-1]]
    for task in tasks[1:]:
        body = "".join(json.dumps(line, separators=(",", ":")) + "\n" for line in lines(task, plan, pattern)).encode()
        closing = {"lines": body.count(b"\n"), "sha256": hashlib.sha256(body).hexdigest()}
        path = folder / "results" / task["key"][:2] / f"{task['key']}.jsonl"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(body + json.dumps(closing, separators=(",", ":")).encode() + b"\n")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
