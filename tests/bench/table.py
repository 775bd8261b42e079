#!/usr/bin/env python3
"""table.py RESULT.json… --write OUT.json [--ratios FILE [--store]]: joins the results of Google Benchmark and prints them
as one table.

A benchmark says how many items it did (SetItemsProcessed) and calls them by its label ("blocks", "setpoints", …).
Its cost an item in steps of the reference loop of the same program stands beside the one that FILE holds from a quiet
run; --store writes the new ones there.
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


def join(paths):
    """All results as one object, and a row a benchmark: (name, ns an item, items a second, unit, steps, bytes)."""
    joined = {"context": None, "benchmarks": []}
    table = []
    for path in paths:
        result = json.loads(path.read_text())
        joined["context"] = joined["context"] or result["context"]
        rows = list(rows_of(result))
        reference = next((ns for name, ns, *_ in rows if name.split("/")[0] == REFERENCE), None)
        for run in result["benchmarks"]:
            joined["benchmarks"].append({"program": path.stem, "reference_ns": reference, **run})
        table += [(name, ns, rate, unit, ns / reference if ns and reference else None, size)
                  for name, ns, rate, unit, size in rows]
    table.sort(key=lambda row: not row[0].startswith(REFERENCE))
    return joined, table


def show(table, stored):
    width = max(len(name) for name, *_ in table)
    print(f"{'benchmark':{width}}  {'ns an item':>12}  {'items a second':>24}  {'reference steps':>15}  {'stored':>10}"
          f"  {'change':>7}  {'bytes an item':>13}")
    for name, ns, rate, unit, ratio, size in table:
        if ns is None:
            print(f"{name:{width}}  failed: {unit}")
            continue
        before = stored.get(name)
        change = f"{100 * (ratio / before - 1):+.0f} %" if ratio and before else ""
        print(f"{name:{width}}  {ns:12.4g}  {scaled(rate) + unit:>24}  {'' if ratio is None else f'{ratio:.4g}':>15}"
              f"  {before or '':>10}  {change:>7}  {'' if size is None else round(size):>13}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results", nargs="+", type=pathlib.Path)
    parser.add_argument("--write", type=pathlib.Path, required=True)
    parser.add_argument("--ratios", type=pathlib.Path)
    parser.add_argument("--store", action="store_true")
    arguments = parser.parse_args()

    joined, table = join(arguments.results)
    arguments.write.write_text(json.dumps(joined, indent=1) + "\n")
    stored = json.loads(arguments.ratios.read_text()) if arguments.ratios and arguments.ratios.exists() else {}
    show(table, stored)
    if arguments.store:
        measured = {name: float(f"{ratio:.4g}") for name, *_, ratio, _ in table if ratio and not name.startswith(REFERENCE)}
        arguments.ratios.write_text(json.dumps({**stored, **measured}, indent=1, sort_keys=True, ensure_ascii=False) + "\n")


if __name__ == "__main__":
    main()
