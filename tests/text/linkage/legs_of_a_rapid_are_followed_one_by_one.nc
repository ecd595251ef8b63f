(run with: --machine arm4 --param LRP=0)
O0001 (X and Y are as fast: both go 90, to X110 Y250, which is too far)
G01 X200. Y100. F600.
G00 Y160. (expect moves: rapid X200 Y160)
X60. Y250. (expect alarm OUT_OF_REACH says the tip X110 Y250) (expect moves: none)
M30
(finally machine X200 Y160)
