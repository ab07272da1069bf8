# OpenSTA, without wires: FO4 of the library, the worst path of each cycle, the slack under the constraint. Written by dualsplit,
# do not edit; run by `make timing`.
#
# FO4 is the delay of the inverter DRIVER that drives four of its kind, in a chain of such, mean of both edges. A cycle's paths
# are those from the registers (at first, the inputs, which the netlist's commonest register drives from time 0) at which the cycle before
# ended to all registers that no earlier cycle reaches. Enable and reset, which reach registers of all cycles, are left out. The last
# row is behind the last registers. Each row names the register or the output that its path ends at.
set top $env(TOP)
read_liberty ${top}_map.lib
set_cmd_units -time ps -capacitance fF
set far 1e6

proc worst {paths} {
    set worst [lindex $paths 0]
    foreach path $paths {
        if {[get_property $path slack] < [get_property $worst slack]} { set worst $path }
    }
    return $worst
}

proc delay {path} {
    global far
    return [expr {$far - [get_property $path slack]}]
}

# The pins of a library's cell that have a direction.
proc pins {cell direction} {
    set found {}
    foreach pin [get_lib_pins [get_property $cell full_name]/*] {
        if {[get_property $pin direction] eq $direction} { lappend found [get_property $pin full_name] }
    }
    return $found
}

# The chain of inverters, between whose places 4 and 8 FO4 is measured.
set inverter [get_lib_cells */$env(DRIVER)]
set in [pins $inverter input]
set out [pins $inverter output]
set chain [open ${top}_fo4.v w]
puts $chain "module fo4 (input a, output y, output z);"
set from a
for {set place 1} {$place <= 10} {incr place} {
    puts $chain "wire n$place; $env(DRIVER) chain_$place (.${in}($from), .${out}(n$place));"
    for {set load 1} {$load <= 3} {incr load} { puts $chain "$env(DRIVER) load_${place}_$load (.${in}(n$place));" }
    set from n$place
}
puts $chain "assign y = n4; assign z = n8;\nendmodule"
close $chain
read_verilog ${top}_fo4.v
link_design fo4
create_clock -name ideal -period $far
set_input_delay 0 -clock ideal [get_ports a]
set_output_delay 0 -clock ideal [all_outputs]
set fo4 0
foreach edge {-rise_to -fall_to} {
    foreach {port sign} {y -1 z 1} {
        set fo4 [expr {$fo4 + $sign * [delay [worst [find_timing_paths $edge [get_ports $port]]]] / 8}]
    }
}
puts [format "FO4 %.1f ps" $fo4]

read_verilog ${top}_netlist.v
link_design $top
create_clock -name clk_i -period $far [get_ports clk_i]
set front {}
foreach port [all_inputs] {
    if {[lsearch {clk_i en_i rst_ni} [get_property $port full_name]] < 0} { lappend front $port }
}
set commonest ""
set count() 0
foreach register [all_registers -cells] {
    set kind [get_property $register ref_name]
    if {![info exists count($kind)]} { set count($kind) 0 }
    incr count($kind)
    if {$count($kind) > $count($commonest)} { set commonest $kind }
}
set_input_delay 0 -clock clk_i $front
set_output_delay 0 -clock clk_i [all_outputs]
set_driving_cell -lib_cell $commonest $front
set_load $env(LOAD) [all_outputs]
for {set cycle 1} {[llength $front] > 0} {incr cycle} {
    set ends {}
    set next {}
    foreach end [get_fanout -from $front -flat -endpoints_only] {
        set name [get_property $end full_name]
        if {[info exists seen($name)]} continue
        set seen($name) 1
        lappend ends $end
        if {[string first / $name] < 0} continue
        foreach pin [get_pins -of_objects [get_cells -of_objects $end]] {
            if {[get_property $pin direction] eq "output"} { lappend next $pin }
        }
    }
    if {[llength $ends] == 0} break
    set path [worst [find_timing_paths -from $front -to $ends]]
    # A register is called by the wire that it drives, `$`, and its kind.
    regsub {\$.*} [get_property [get_property $path endpoint] full_name] {} end
    puts [format "cycle %d %6.0f ps %5.1f FO4 to %s" $cycle [delay $path] [expr {[delay $path] / $fo4}] $end]
    set front $next
}

# As the constraint has it, whose times are in ns. Linking anew forgets the one above.
read_verilog ${top}_netlist.v
link_design $top
set_cmd_units -time ns
read_sdc $top.sdc
set_driving_cell -lib_cell $env(DRIVER) [all_inputs]
set_load $env(LOAD) [all_outputs]
report_checks -path_delay max -digits 3
set slack [worst_slack]
puts "slack $slack ns"
puts "clock [format %.1f [expr 1000.0 / ($env(PERIOD) - $slack)]] MHz"
