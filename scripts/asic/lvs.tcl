# Netgen: how it compares. Transistors have their widths and lengths; sources and drains may be exchanged.
permute default
property default
property {-circuit1 nfet} remove ad pd as ps
property {-circuit1 pfet} remove ad pd as ps
property {-circuit2 nfet} remove ad pd as ps
property {-circuit2 pfet} remove ad pd as ps
