(run with: --machine arm4 --param LRP=1)
O0001 (the straight way between two tips within reach stays there)
G01 X200. Y100. F600.
G00 Y160.
X60. Y250. (expect moves: rapid X60 Y250)
M30
(finally machine X60 Y250)
