(run with: --machine mill3 --param overrun.X=0.5)
O1 (G-8: the parameter is in mm)
G20
G60 X1. (expect moves: rapid X24.9 stop; rapid X25.4 stop)
M30
