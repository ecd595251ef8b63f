(run with: --machine mill3 --param overrun.X=0.5 --param overrun.Y=0.5)
O1 (G-8)
G60 X10. (expect moves: rapid X9.5 Y0 stop; rapid X10 Y0 stop)
G60 X10. Y4. (expect moves: rapid X10 Y3.5 stop; rapid X10 Y4 stop)
G60 X10. Y4. (expect moves: none)
M30
