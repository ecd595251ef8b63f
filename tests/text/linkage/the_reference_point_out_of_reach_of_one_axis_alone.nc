(run with: --machine arm4)
O0001 (X of the reference is 264, with Y at 50 that is too far; the tool stays at the intermediate point)
G01 X200. Y50. F600.
G28 X210. (expect alarm OUT_OF_REACH says the tip X264 Y50)
M30
