# Magic: makes NAME.mag of the routed design NAME.def. From the environment: NAME, LEF.
drc off
snap internal
lef read $env(LEF)
def read $env(NAME)
load $env(NAME)
save $env(NAME)
quit -noprompt
