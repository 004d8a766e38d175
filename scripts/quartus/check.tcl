# Reads a Quartus project as Quartus would, as far as files, names and ports go; to be run by `yosys -c` in the
# project's folder, with its name in PROJECT. Quartus's own commands note down what they are given.
set project $::env(PROJECT)
set errors {}
proc fault {text} { lappend ::errors $text }

# What Quartus knows of the assignments that the generator writes, and whether the value is a file.
array set known {
    FAMILY value DEVICE value TOP_LEVEL_ENTITY value VERILOG_INPUT_VERSION value VERILOG_FILE file SDC_FILE file
}
array set found {}
proc set_global_assignment {option name value} {
    if {$option ne "-name"} { fault "set_global_assignment: found $option, expected -name" }
    if {![info exists ::known($name)]} { fault "unknown assignment $name"; return }
    if {$::known($name) eq "file" && ![file isfile $value]} { fault "$name: found no file $value" }
    set ::found($name) $value
}
proc set_instance_assignment {option name value to pin} {
    if {"$option $name $to" ne "-name VIRTUAL_PIN -to"} { fault "unknown instance assignment $name" }
    if {$pin ne "*"} { lappend ::pins $pin }
}
proc get_ports {pin} { lappend ::pins $pin; return $pin }
proc create_clock {args} {
    array set given [lrange $args 0 end-1]
    if {![string is double -strict $given(-period)] || $given(-period) <= 0} { fault "create_clock: no period" }
    incr ::clocks
}
proc PROJECT_REVISION {sign name} { set ::revision $name }

set pins {}
set clocks 0
set revision {}
source $project.qpf
source $project.qsf
if {$revision ne $project} { fault "PROJECT_REVISION is $revision, expected $project" }
foreach name [array names known] {
    if {![info exists found($name)]} { fault "no assignment of $name" }
}
if {![llength $errors]} {
    source $found(SDC_FILE)
    if {$clocks != 1} { fault "found $clocks clocks, expected 1" }
    yosys -import
    yosys read_verilog -lib $found(VERILOG_FILE)
    # A name that is not there ends Yosys.
    # `=` selects in a module of which the ports alone were read.
    foreach pin $pins { yosys select -assert-count 1 =$found(TOP_LEVEL_ENTITY)/i:$pin }
}
foreach text $errors { puts stderr "$project: $text" }
exit [expr {[llength $errors] > 0}]
