# The component core-3-leaf-5-local7-rgb6d-n64 for Intel's Platform Designer, which finds this file by its name on its search path.
# Written by photoncube 0.2.0, `photoncube generate --machine leaf-5-local7-rgb6d-n64 --chains 3`; do not edit.
package require -exact qsys 16.1

set_module_property NAME photoncube_core_3_leaf_5_local7_rgb6d_n64
set_module_property VERSION 0.2.0
set_module_property DISPLAY_NAME "Photoncube core-3-leaf-5-local7-rgb6d-n64"
set_module_property DESCRIPTION "3 chains of leaf-5-local7-rgb6d-n64 behind AXI4-Stream and AXI4-Lite"
set_module_property GROUP Photoncube
set_module_property INTERNAL false
set_module_property EDITABLE false

foreach fileset {QUARTUS_SYNTH SIM_VERILOG} {
    add_fileset $fileset $fileset "" ""
    set_fileset_property $fileset TOP_LEVEL photoncube_core_3_leaf_5_local7_rgb6d_n64
    add_fileset_file photoncube_core_3_leaf_5_local7_rgb6d_n64.v VERILOG PATH photoncube_core_3_leaf_5_local7_rgb6d_n64.v TOP_LEVEL_FILE
}

add_interface aclk clock end
add_interface_port aclk aclk clk Input 1

add_interface aresetn reset end
set_interface_property aresetn associatedClock aclk
set_interface_property aresetn synchronousEdges BOTH
add_interface_port aresetn aresetn reset_n Input 1

add_interface s_axi axi4lite end
set_interface_property s_axi associatedClock aclk
set_interface_property s_axi associatedReset aresetn
set_interface_property s_axi readAcceptanceCapability 1
set_interface_property s_axi writeAcceptanceCapability 1
set_interface_property s_axi combinedAcceptanceCapability 2
add_interface_port s_axi s_axi_awaddr awaddr Input 9
add_interface_port s_axi s_axi_awprot awprot Input 3
add_interface_port s_axi s_axi_awvalid awvalid Input 1
add_interface_port s_axi s_axi_awready awready Output 1
add_interface_port s_axi s_axi_wdata wdata Input 32
add_interface_port s_axi s_axi_wstrb wstrb Input 4
add_interface_port s_axi s_axi_wvalid wvalid Input 1
add_interface_port s_axi s_axi_wready wready Output 1
add_interface_port s_axi s_axi_bresp bresp Output 2
add_interface_port s_axi s_axi_bvalid bvalid Output 1
add_interface_port s_axi s_axi_bready bready Input 1
add_interface_port s_axi s_axi_araddr araddr Input 9
add_interface_port s_axi s_axi_arprot arprot Input 3
add_interface_port s_axi s_axi_arvalid arvalid Input 1
add_interface_port s_axi s_axi_arready arready Output 1
add_interface_port s_axi s_axi_rdata rdata Output 32
add_interface_port s_axi s_axi_rresp rresp Output 2
add_interface_port s_axi s_axi_rvalid rvalid Output 1
add_interface_port s_axi s_axi_rready rready Input 1

add_interface s_axis_photons axi4stream end
set_interface_property s_axis_photons associatedClock aclk
set_interface_property s_axis_photons associatedReset aresetn
add_interface_port s_axis_photons s_axis_photons_tdata tdata Input 512
add_interface_port s_axis_photons s_axis_photons_tvalid tvalid Input 1
add_interface_port s_axis_photons s_axis_photons_tready tready Output 1
add_interface_port s_axis_photons s_axis_photons_tlast tlast Input 1
add_interface_port s_axis_photons s_axis_photons_tdest tdest Input 2

add_interface s_axis_queries axi4stream end
set_interface_property s_axis_queries associatedClock aclk
set_interface_property s_axis_queries associatedReset aresetn
add_interface_port s_axis_queries s_axis_queries_tdata tdata Input 128
add_interface_port s_axis_queries s_axis_queries_tvalid tvalid Input 1
add_interface_port s_axis_queries s_axis_queries_tready tready Output 1
add_interface_port s_axis_queries s_axis_queries_tlast tlast Input 1
add_interface_port s_axis_queries s_axis_queries_tdest tdest Input 2

add_interface m_axis_results axi4stream start
set_interface_property m_axis_results associatedClock aclk
set_interface_property m_axis_results associatedReset aresetn
add_interface_port m_axis_results m_axis_results_tdata tdata Output 64
add_interface_port m_axis_results m_axis_results_tvalid tvalid Output 1
add_interface_port m_axis_results m_axis_results_tready tready Input 1
add_interface_port m_axis_results m_axis_results_tlast tlast Output 1
add_interface_port m_axis_results m_axis_results_tid tid Output 2
add_interface_port m_axis_results m_axis_results_tuser tuser Output 1

add_interface irq interrupt end
set_interface_property irq associatedClock aclk
set_interface_property irq associatedReset aresetn
set_interface_property irq associatedAddressablePoint s_axi
add_interface_port irq irq irq Output 1
