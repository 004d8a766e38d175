# Magic: puts the geometry of the library's cells into NAME.mag, checks the design rules, once more with a planted sliver of metal,
# which must be found, and writes NAME.gds and, with the sliver, NAME_sliver.gds. From the environment: NAME, CELLS (their GDS).
set report [open drc.txt w]
proc say {line} {
    puts $::report $line
    puts $line
}
proc check {title} {
    select top cell
    drc check
    drc catchup
    say "$title: [drc list count total]"
    foreach {rule places} [drc listall why] {
        say "    $rule: [llength $places] places, the first at [lindex $places 0]"
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
