#!/usr/bin/env python3
"""table.py RESULT.json… --write OUT.json: joins the results of Google Benchmark and prints them as one table.

A benchmark says how many items it did (SetItemsProcessed) and calls them by its label ("blocks", "setpoints", …).
The last column is its cost an item in steps of the reference loop of the same program.
"""

import argparse
import json
import pathlib

REFERENCE = "reference_loop"
TO_NS = {"ns": 1.0, "us": 1e3, "ms": 1e6, "s": 1e9}


def scaled(value):
    for factor, prefix in ((1e9, "G"), (1e6, "M"), (1e3, "k")):
        if value >= factor:
            return f"{value / factor:.3g} {prefix}"
    return f"{value:.3g} "


def rows_of(result):
    """(name, ns an item, items a second, unit, bytes an item) of each benchmark; of aggregates only the median."""
    for run in result["benchmarks"]:
        if run.get("error_occurred"):
            yield run["name"], None, None, run.get("error_message", "failed"), None
            continue
        if run["run_type"] == "aggregate" and run.get("aggregate_name") != "median":
            continue
        rate = run.get("items_per_second") or 1e9 / (run["cpu_time"] * TO_NS[run["time_unit"]])
        unit = run.get("label") or "runs"
        yield run["name"], 1e9 / rate, rate, unit, run.get("bytes_an_item")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results", nargs="+", type=pathlib.Path)
    parser.add_argument("--write", type=pathlib.Path, required=True)
    arguments = parser.parse_args()

    joined = {"context": None, "benchmarks": []}
    table = []
    for path in arguments.results:
        result = json.loads(path.read_text())
        joined["context"] = joined["context"] or result["context"]
        rows = list(rows_of(result))
        reference = next((ns for name, ns, *_ in rows if name.split("/")[0] == REFERENCE), None)
        for run in result["benchmarks"]:
            joined["benchmarks"].append({"program": path.stem, "reference_ns": reference, **run})
        table += [(name, ns, rate, unit, ns / reference if ns and reference else None, size)
                  for name, ns, rate, unit, size in rows]
    arguments.write.write_text(json.dumps(joined, indent=1) + "\n")

    table.sort(key=lambda row: not row[0].startswith(REFERENCE))
    width = max(len(name) for name, *_ in table)
    print(f"{'benchmark':{width}}  {'ns an item':>12}  {'items a second':>24}  {'reference steps':>15}  {'bytes an item':>13}")
    for name, ns, rate, unit, ratio, size in table:
        if ns is None:
            print(f"{name:{width}}  failed: {unit}")
        else:
            print(f"{name:{width}}  {ns:12.4g}  {scaled(rate) + unit:>24}  {'' if ratio is None else round(ratio, 3):>15}"
                  f"  {'' if size is None else round(size):>13}")


if __name__ == "__main__":
    main()
