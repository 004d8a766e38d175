# OpenSTA: the longest path of NAME.v, with cells alone, then with the wires of NAME.spef and the clock's tree. From the environment:
# NAME, LIBERTY.
proc say {what number} { puts [format "%s: %.6f" $what $number] }
# The period in ns at which slacks are computed; the shortest period follows from them.
set period 20
set_cmd_units -time ns
read_liberty $env(LIBERTY)
read_verilog $env(NAME).v
link_design $env(NAME)
create_clock -name clock -period $period [get_ports clock]
# Whoever is at the ports has registers of the library, on a clock that comes when it comes to the middle of these.
create_clock -name outside -period $period
foreach port [all_inputs] {
    if {[get_name $port] ne "clock"} {
        set_driving_cell -lib_cell DFFPOSX1 -pin Q $port
        set_input_delay 0 -clock outside $port
    }
}
set_output_delay 0 -clock outside [all_outputs]
say "period with cells alone, ns" [expr {$period - 1e9 * [sta::worst_slack_cmd max]}]

read_spef $env(NAME).spef
set_propagated_clock [get_clocks clock]
# Arrivals are there once a slack was asked for.
sta::worst_slack_cmd max
set arrivals {}
foreach pin [all_registers -clock_pins] {
    set name [get_full_name $pin]
    with_output_to_variable said [list report_arrival $name]
    if {![regexp {\(clock \^\) r ([\d.]+):([\d.]+)} $said all first last]} {
        error "found \"$said\" at $name, expected an arrival of the clock"
    }
    lappend arrivals $last
}
set latency [expr ([join $arrivals +]) / double([llength $arrivals])]
set_clock_latency $latency [get_clocks outside]
say "registers" [llength $arrivals]
say "clock latency, ns" $latency
set order [lsort -real $arrivals]
say "first clock, ns" [lindex $order 0]
say "last clock, ns" [lindex $order end]
say "period with wires, ns" [expr {$period - 1e9 * [sta::worst_slack_cmd max]}]
puts "hold:"
report_checks -path_delay min -from [all_registers -clock_pins] -to [all_registers -data_pins] -format full_clock_expanded -digits 4
puts "setup:"
report_checks -path_delay max -format full_clock_expanded -fields {slew cap} -digits 4
