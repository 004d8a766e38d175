# Magic: reads GDS, $FILE.gds, alone and extracts its transistors to $FILE.spice. From the environment: NAME, FILE.
drc off
# The cells have shapes on half of the grid.
gds rescale true
gds read $env(FILE).gds
load $env(NAME)
select top cell
port makeall
extract no all
extract all
ext2spice lvs
ext2spice -o $env(FILE).spice $env(NAME)
quit -noprompt
