(run with: --machine arm4)
O0001 (K repeats: the alarm belongs to the block of all holes)
G01 X200. Y50. F600.
G91 G99 G81 X20. Z-5. R-2. K5 F100. (expect alarm OUT_OF_REACH) (expect moves: rapid X220 Z0; rapid Z-2; line Z-7; rapid Z-2; rapid X240; line Z-7; rapid Z-2)
G80
M30
(finally machine X240 Y50 Z-2)
