"""Every diagnostic of slang about Verilog files: slang.py TOP FILE... Ends with exit code 1 if there is any."""

import sys

from pyslang.driver import Driver

driver = Driver()
driver.addStandardArgs()
top, files = sys.argv[1], sys.argv[2:]
# Bits that nothing reads are gathered in a net called `unused`; who uses the package decides what of it.
allowed = "-Wno-unused-net -Wno-unused-package-parameter -Wno-unused-package-typedef"
options = f"slang -Weverything {allowed} --top {top} {' '.join(files)}"
assert driver.parseCommandLine(options) and driver.processOptions() and driver.parseAllSources()
compilation = driver.createCompilation()
driver.reportCompilation(compilation, True)
driver.runAnalysis(compilation)
sys.exit(1 if driver.diagEngine.numErrors + driver.diagEngine.numWarnings else 0)
