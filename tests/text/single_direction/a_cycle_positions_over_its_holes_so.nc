(run with: --machine mill3 --param overrun.X=0.5 --param overrun.Z=1)
O1 (G-8: over the hole, but not along the drilling axis)
G00 Z10.
G99 G81 G60 X10. Z-5. R2. F100 (expect moves: rapid X9.5 Z10 stop; rapid X10 Z10 stop; rapid Z2; line Z-5; rapid Z2)
X20. (expect moves: rapid X20 Z2; line Z-5; rapid Z2)
G60 X30. (expect moves: rapid X29.5; rapid X30; line Z-5; rapid Z2)
G80
M30
