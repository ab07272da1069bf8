# OpenSTA: the slowest path of the mapped netlist, no wires. Written by dualsplit, do not edit; run by `make timing`.
foreach library $::env(LIBERTY) { read_liberty $library }
read_verilog $::env(TOP)_netlist.v
link_design $::env(TOP)
read_sdc $::env(TOP).sdc
set inputs [all_inputs]
set_driving_cell -lib_cell $::env(DRIVER) $inputs
set_load $::env(LOAD) [all_outputs]
report_checks -path_delay max -digits 3
set slack [worst_slack]
puts "slack $slack ns"
puts "clock [format %.1f [expr 1000.0 / ($::env(PERIOD) - $slack)]] MHz"
