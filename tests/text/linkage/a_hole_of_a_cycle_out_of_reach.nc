(run with: --machine arm4)
O0001 (the holes before it are drilled)
G01 X200. Y50. F600.
G99 G81 X150. Y50. Z-5. R2. F100. (expect moves: rapid X150 Y50 Z0; rapid Z2; line Z-5; rapid Z2)
X230. (expect moves: rapid X230 Z2; line Z-5; rapid Z2)
X300. (expect alarm OUT_OF_REACH at X300.) (expect moves: none)
X100.
G80
M30
(finally machine X230 Y50 Z2)
