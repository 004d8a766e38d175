create_clock -name clock -period 10 [get_ports clock]
