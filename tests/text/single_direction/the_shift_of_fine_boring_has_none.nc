(run with: --machine mill3 --param overrun.X=0.5)
O1 (G-8)
M03 S500
G00 Z10.
G99 G76 G60 X10. Z-5. R2. Q1. F100 (expect moves: rapid X9.5 Z10; rapid X10 Z10; rapid Z2; line Z-5; rapid X11; rapid Z2; rapid X10)
G80
M30
