"""Run Table 2 of the paper on a Dask cluster: here one of two processes on this machine.

With the address of a scheduler (``python cluster.py tcp://host:8786``) it runs there; the workers need cdpr and no
files. The rows are the same as those of ``cdpr batch``, whatever the cluster.
"""

import sys
from pathlib import Path

from distributed import Client, LocalCluster

import cdpr

EXPERIMENT = Path(__file__).resolve().parents[2] / "experiments" / "table2.toml"


def main(address: str | None = None, trials: int | None = None) -> None:
    """Run the experiment, print how costs compare, and keep the folder for ``cdpr report``."""
    cluster = address or LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None)
    with Client(cluster) as client:
        result = cdpr.run_batch(
            EXPERIMENT,
            client.get_executor(),
            progress=lambda done, total: print(f"\r{done} of {total} trials", end="", file=sys.stderr),
            trials=trials,
        )
    print(file=sys.stderr)
    for test in result.t_tests:
        print(f"{test['group']}: p = {test['p']:.3g} ({test['measure']}, {test['a'][1]} and {test['b'][1]})")
    result.save("table2")
    print("wrote table2; next: cdpr report table2")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else None, int(sys.argv[2]) if len(sys.argv) > 2 else None)
