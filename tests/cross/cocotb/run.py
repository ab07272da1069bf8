"""Builds the exported files of a pipeline with Icarus and runs the cocotb tests: run.py FOLDER PIPELINE.

Ends with exit code 1 if a test fails.
"""

import sys
from pathlib import Path

from cocotb_tools.check_results import get_results
from cocotb_tools.runner import get_runner

folder, pipeline = Path(sys.argv[1]).resolve(), sys.argv[2]
build = folder / "cocotb"
runner = get_runner("icarus")
runner.build(
    sources=[folder / f"{pipeline}{end}" for end in (".v", "_stream.v", "_axis.v")],
    hdl_toplevel=f"{pipeline}_axis",
    build_dir=build,
    timescale=("1ns", "1ps"),
)
results = runner.test(
    hdl_toplevel=f"{pipeline}_axis",
    test_module="axis",
    build_dir=build,
    test_dir=Path(__file__).resolve().parent,
    results_xml=str(build / "results.xml"),
    extra_env={"PIPELINE": pipeline, "FOLDER": str(folder)},
)
tests, failures = get_results(results)
sys.exit(0 if tests > 0 and failures == 0 else 1)
