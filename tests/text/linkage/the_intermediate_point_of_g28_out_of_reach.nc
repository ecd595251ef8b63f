(run with: --machine arm4)
O0001 (no axis leaves)
G01 X200. Y50. F600.
G28 X250. Y100. (expect alarm OUT_OF_REACH says the tip X250 Y100) (expect moves: none)
M30
(finally machine X200 Y50)
