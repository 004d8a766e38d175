# Magic: puts the geometry of the library's cells into NAME.mag, patches pieces of metal that are too small, checks the design rules,
# once more with a planted sliver of metal, which must be found, and writes NAME.gds and, with the sliver, NAME_sliver.gds. From the
# environment: NAME, CELLS (their GDS).
set report [open drc.txt w]
proc say {line} {
    puts $::report $line
    puts $line
}
proc errors {} {
    select top cell
    drc check
    drc catchup
    drc list count total
}
proc check {title} {
    say "$title: [errors]"
    foreach {rule places} [drc listall why] {
        say "    $rule: [llength $places] places, the first at [lindex $places 0]"
    }
}
# qrouter leaves some vias whose metal below reaches nothing else. That metal has the size of the via, which is less than the least
# area of a piece of metal. One lambda more at a side is enough, and the tracks leave that much room at most sides. The place is a box
# in lambda. A side that leaves as many errors is taken back.
proc patch {metal place} {
    lassign $place left bottom right top
    set before [errors]
    foreach side [list \
            [list $right $bottom [expr {$right + 1}] $top] [list $left $top $right [expr {$top + 1}]] \
            [list [expr {$left - 1}] $bottom $left $top] [list $left [expr {$bottom - 1}] $right $bottom]] {
        box {*}$side
        paint $metal
        if {[errors] < $before} {
            say "patch of $metal: $side"
            return
        }
        box {*}$side
        erase $metal
    }
}
proc patch_small_pieces {} {
    foreach {rule places} [drc listall why] {
        if {[regexp {^Metal(\d) area} $rule -> layer]} {
            foreach place $places {patch metal$layer $place}
        }
    }
}
drc off
# The cells are written byte for byte as they were read.
gds readonly true
gds rescale false
gds read $env(CELLS)
load $env(NAME)
select top cell
expand
lassign [box values] left bottom right top
say "kinds of cells: [llength [cellname list children $env(NAME)]]"
say "left, bottom, right and top in lambda: $left $bottom $right $top"
drc euclidean on
drc on
check "DRC errors before patches"
patch_small_pieces
check "DRC errors"
# Without p-wells: the cells have none, and those that magic would add between them are narrower than the rules allow.
cif ostyle lambda=0.10()
gds write $env(NAME)
set x [expr {($left + $right) / 2}]
set y [expr {($bottom + $top) / 2}]
box $x $y [expr {$x + 2}] [expr {$y + 400}]
paint metal3
check "DRC errors with a planted sliver"
gds write $env(NAME)_sliver
close $report
quit -noprompt
