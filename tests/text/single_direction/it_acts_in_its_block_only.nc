(run with: --machine mill3 --param overrun.X=0.5)
O1 (G-1: G01 stays in force)
G01 X1. F100
G60 X10. (expect moves: rapid X9.5; rapid X10)
X20. (expect moves: line X20 F100)
#100=#4001 (expect #100=1)
M30
