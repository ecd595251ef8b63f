(run with: --machine arm4)
O0001 (both ends are within reach)
G01 X200. Y100. F600.
G02 X200. Y-100. R110. (expect alarm OUT_OF_REACH says the tip X264.174243 Y0)
M30
(finally machine X200 Y100)
