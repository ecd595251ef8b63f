(run with: --machine arm4)
O0001 (G53 is never linear)
G01 X200. Y100. F600.
G01 Y160.
G00 G53 X60. Y250. (expect alarm OUT_OF_REACH says the tip X110 Y250)
M30
(finally machine X200 Y160)
