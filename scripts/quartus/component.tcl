# Reads a component of Platform Designer (TOP_hw.tcl) as far as its files, interfaces and ports go; to be run by `yosys -c` in the
# component's folder, with the name of its top module in TOP. The commands of Platform Designer note down what they are given.
set top $::env(TOP)
set errors {}
proc fault {text} { lappend ::errors $text }
package provide qsys 16.1

# Each type of interface with its roles at the side `end`: the direction, the width (0 for any), and whether the role must be there.
array set roles {
    clock {clk {Input 1 must}}
    reset {reset_n {Input 1 must}}
    interrupt {irq {Output 1 must}}
    axi4stream {
        tvalid {Input 1 must} tready {Output 1 must} tdata {Input 0 must} tlast {Input 1 may} tdest {Input 0 may} tid {Input 0 may}
        tuser {Input 0 may}
    }
    axi4lite {
        awaddr {Input 0 must} awprot {Input 3 must} awvalid {Input 1 must} awready {Output 1 must}
        wdata {Input 32 must} wstrb {Input 4 must} wvalid {Input 1 must} wready {Output 1 must}
        bresp {Output 2 must} bvalid {Output 1 must} bready {Input 1 must}
        araddr {Input 0 must} arprot {Input 3 must} arvalid {Input 1 must} arready {Output 1 must}
        rdata {Output 32 must} rresp {Output 2 must} rvalid {Output 1 must} rready {Input 1 must}
    }
}
# The properties that an interface of each type must have; a value is the type of the interface that is named, or `any`.
array set properties {
    clock {}
    reset {associatedClock clock synchronousEdges any}
    interrupt {associatedClock clock associatedReset reset associatedAddressablePoint axi4lite}
    axi4stream {associatedClock clock associatedReset reset}
    axi4lite {
        associatedClock clock associatedReset reset
        readAcceptanceCapability any writeAcceptanceCapability any combinedAcceptanceCapability any
    }
}
set module_properties {NAME VERSION DISPLAY_NAME DESCRIPTION GROUP INTERNAL EDITABLE}

proc set_module_property {name value} {
    if {$name ni $::module_properties} { fault "unknown module property $name" }
    set ::module($name) $value
}
proc add_fileset {name kind callback display} {
    if {$kind ni {QUARTUS_SYNTH SIM_VERILOG}} { fault "unknown file set $kind" }
    set ::filesets($name) {}
    set ::fileset $name
}
proc set_fileset_property {name property value} {
    if {$property ne "TOP_LEVEL" || $value ne $::top} { fault "file set $name: found $property $value, expected TOP_LEVEL $::top" }
}
proc add_fileset_file {name kind from path args} {
    if {"$kind $from" ne "VERILOG PATH"} { fault "$name: found $kind $from, expected VERILOG PATH" }
    if {![file isfile $path]} { fault "$name: found no file $path" }
    lappend ::filesets($::fileset) $path
}
proc add_interface {name kind side} {
    if {![info exists ::roles($kind)]} { fault "interface $name: unknown type $kind"; return }
    if {$side ni {start end}} { fault "interface $name: found side $side, expected start or end" }
    if {[info exists ::kinds($name)]} { fault "interface $name is there twice" }
    set ::kinds($name) $kind
    set ::sides($name) $side
    set ::given($name) {}
    set ::has($name) {}
}
proc set_interface_property {name property value} {
    if {![info exists ::kinds($name)]} { fault "$property of an unknown interface $name"; return }
    lappend ::given($name) $property $value
}
proc add_interface_port {name port role direction width} {
    if {![info exists ::kinds($name)]} { fault "port $port of an unknown interface $name"; return }
    if {$port in $::ports} { fault "port $port is there twice" }
    lappend ::ports $port
    lappend ::declared $port $direction $width
    if {$role in $::has($name)} { fault "interface $name has the role $role twice" }
    lappend ::has($name) $role
    array set known $::roles($::kinds($name))
    if {![info exists known($role)]} { fault "interface $name: unknown role $role"; return }
    lassign $known($role) expected bits
    if {$::sides($name) eq "start"} { set expected [expr {$expected eq "Input" ? "Output" : "Input"}] }
    if {$direction ne $expected} { fault "port $port: found $direction, expected $expected" }
    if {$bits && $width != $bits} { fault "port $port: found $width bits, expected $bits" }
}

# What an interface must have.
proc check_interface {name} {
    set kind $::kinds($name)
    foreach {role rule} $::roles($kind) {
        if {[lindex $rule 2] eq "must" && $role ni $::has($name)} { fault "interface $name has no role $role" }
    }
    array set given $::given($name)
    foreach {property type} $::properties($kind) {
        if {![info exists given($property)]} { fault "interface $name has no $property"; continue }
        if {$type eq "any"} continue
        if {![info exists ::kinds($given($property))] || $::kinds($given($property)) ne $type} {
            fault "interface $name: found $property $given($property), expected an interface of type $type"
        }
    }
    foreach property [array names given] {
        if {![dict exists $::properties($kind) $property]} { fault "interface $name: unknown property $property" }
    }
}

set ports {}
set declared {}
source ${top}_hw.tcl
foreach name $module_properties {
    if {![info exists module($name)]} { fault "no module property $name" }
}
if {[info exists module(NAME)] && $module(NAME) ne $top} { fault "NAME is $module(NAME), expected $top" }
foreach name {QUARTUS_SYNTH SIM_VERILOG} {
    if {![info exists filesets($name)] || ![llength $filesets($name)]} { fault "file set $name has no file" }
}
foreach name [array names kinds] { check_interface $name }
foreach text $errors { puts stderr "${top}_hw.tcl: $text" }
if {[llength $errors]} { exit 1 }

yosys -import
foreach path $filesets(QUARTUS_SYNTH) { yosys read_verilog -lib $path }
# A port that is not there with that direction and width ends Yosys, and so do ports that no interface has.
foreach {port direction width} $declared {
    set kind [expr {$direction eq "Input" ? "i" : "o"}]
    yosys select -assert-count 1 =$top/$kind:$port =$top/s:$width %i
}
yosys select -assert-count [llength $ports] =$top/x:*
