(run with: --machine mill3 --param overrun.X=2)
O1 (G-8)
G00 X9.
G60 X10. (expect moves: rapid X8 stop; rapid X10 stop)
G60 X12. (expect moves: rapid X12 stop)
M30
