# OpenSTA: the worst path of each cycle of a mapped pipeline. `stages` calls it and sets the environment.
#
# A cycle's paths are those from the registers (at first, the inputs) at which the cycle before ended to all registers that no
# earlier cycle reaches. The enable, which reaches every register, is left out. The last row is behind the last registers.
read_liberty $env(LIBRARY)
set_cmd_units -time ps -capacitance fF
set far 1e6

proc arrival {paths} {
    global far
    return [expr {$far - [get_property [lindex $paths 0] slack]}]
}

read_verilog $env(CHAIN)
link_design fo4
create_clock -name ideal -period $far
set_input_delay 0 -clock ideal [get_ports a]
set_output_delay 0 -clock ideal [all_outputs]
set fo4 0
foreach edge {-rise_to -fall_to} {
    foreach {port sign} {y -1 z 1} {
        set fo4 [expr {$fo4 + $sign * [arrival [find_timing_paths $edge [get_ports $port]]] / 8}]
    }
}

read_verilog $env(MAPPED)
link_design $env(TOP)
create_clock -name clk_i -period $far [get_ports clk_i]
set front {}
foreach port [all_inputs] {
    if {[lsearch {clk_i en_i} [get_property $port full_name]] < 0} { lappend front $port }
}
set_input_delay 0 -clock clk_i $front
set_output_delay 0 -clock clk_i [all_outputs]
set_driving_cell -lib_cell $env(REGISTER) $front
set_load 10 [all_outputs]
puts [format "FO4 %.1f ps" $fo4]
for {set stage 1} {[llength $front] > 0} {incr stage} {
    set ends {}
    set next {}
    foreach end [get_fanout -from $front -flat -endpoints_only] {
        set name [get_property $end full_name]
        if {[info exists seen($name)]} continue
        set seen($name) 1
        lappend ends $end
        set cell [string range $name 0 [string last / $name]-1]
        foreach output {Q QN} {
            if {$cell ne ""} { set next [concat $next [get_pins -quiet $cell/$output]] }
        }
    }
    if {[llength $ends] == 0} break
    set time [arrival [find_timing_paths -from $front -to $ends]]
    puts [format "stage %d %6.0f ps %5.1f FO4" $stage $time [expr {$time / $fo4}]]
    set front $next
}
