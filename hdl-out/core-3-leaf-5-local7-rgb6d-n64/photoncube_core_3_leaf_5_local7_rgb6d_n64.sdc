create_clock -name aclk -period 10 [get_ports aclk]
